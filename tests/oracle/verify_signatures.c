/* The C library as a receiver: what it says of each frame, and its time afterwards.
 *
 * Reads lines, `sequence TIME` for a new receiver or the bytes of a frame, and answers each frame with the result of framing,
 * the status of signing and the time. All numbers are hexadecimal; the key is 00 01 02 ... 1f. */

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "common/mavlink.h"

static mavlink_signing_t signing;
static mavlink_signing_streams_t streams;
static mavlink_status_t status;

static bool allow(const mavlink_status_t *at, uint32_t id)
{
	(void)at;
	return id == MAVLINK_MSG_ID_RADIO_STATUS;
}

static void start(uint64_t time)
{
	memset(&signing, 0, sizeof signing);
	memset(&streams, 0, sizeof streams);
	memset(&status, 0, sizeof status);
	for (unsigned at = 0; at < sizeof signing.secret_key; at++) {
		signing.secret_key[at] = (uint8_t)at;
	}
	signing.timestamp = time;
	signing.accept_unsigned_callback = allow;
	status.signing = &signing;
	status.signing_streams = &streams;
}

static void receive(const char *digits)
{
	static mavlink_message_t arriving, message;
	mavlink_status_t seen;
	uint8_t framing = MAVLINK_FRAMING_INCOMPLETE;
	unsigned byte;
	signing.last_status = MAVLINK_SIGNING_STATUS_NONE;
	for (; sscanf(digits, "%2x", &byte) == 1; digits += 2) {
		framing = mavlink_frame_char_buffer(&arriving, &status, (uint8_t)byte, &message, &seen);
	}
	printf("%x %x %" PRIx64 "\n", framing, (unsigned)signing.last_status, signing.timestamp);
}

int main(void)
{
	char line[1024];
	uint64_t time;
	while (fgets(line, sizeof line, stdin)) {
		if (sscanf(line, "sequence %" SCNx64, &time) == 1) {
			start(time);
		} else {
			receive(line);
		}
	}
	return 0;
}
