//! What is lost, by the numbers of the frames.

use mavlink_wire::{Arrival, Dialect, Frame, Losses, Message, Sender, Table};
use proptest::prelude::*;

use crate::small::{Heartbeat, Small};
use crate::streams::pieces::encoded;

/// Counts frames with these numbers of one component.
fn arrivals<const N: usize>(losses: &mut Losses<N>, component: u8, numbers: &[u8]) -> Vec<Arrival> {
    let count = |&number: &u8| {
        let bytes = encoded(Sender::v2(1, component), number, &Heartbeat::DEFAULT.into());
        losses.count(&Frame::parse(&bytes, Small::TABLE).unwrap())
    };
    numbers.iter().map(count).collect()
}

#[test]
fn gaps_are_losses_across_the_wrap() {
    let mut losses: Losses<2> = Losses::new();
    let expected = [Arrival::First, Arrival::Next, Arrival::Gap(3), Arrival::Next, Arrival::Gap(239)];
    assert_eq!(arrivals(&mut losses, 1, &[253, 254, 2, 3, 243]), expected);
    let counts = losses.of(1, 1).unwrap();
    assert_eq!((counts.received, counts.lost, counts.restarts), (5, 242, 0));
    assert!((counts.loss() - 242.0 / 247.0).abs() < 1e-6);
}

#[test]
fn late_frames_are_taken_back_and_duplicates_lose_nothing() {
    let mut losses: Losses<2> = Losses::new();
    let expected = [Arrival::First, Arrival::Gap(2), Arrival::Late, Arrival::Duplicate, Arrival::Late, Arrival::Next];
    assert_eq!(arrivals(&mut losses, 1, &[254, 1, 255, 1, 0, 2]), expected);
    let counts = losses.of(1, 1).unwrap();
    assert_eq!((counts.received, counts.lost, counts.late, counts.duplicates), (6, 0, 2, 1));
}

#[test]
fn a_sender_that_starts_again_has_lost_nothing() {
    let mut losses: Losses<2> = Losses::new();
    assert_eq!(arrivals(&mut losses, 1, &[100, 0, 1]), [Arrival::First, Arrival::Restart, Arrival::Next]);
    assert_eq!(losses.total().lost, 0);
    // Within the window of late frames it is taken for such, and catches up with itself.
    assert_eq!(arrivals(&mut losses, 1, &[0, 1, 2]), [Arrival::Late, Arrival::Duplicate, Arrival::Next]);
    assert_eq!((losses.total().lost, losses.total().restarts), (0, 1));
}

#[test]
fn a_gap_that_lands_on_zero_is_a_gap() {
    for gap in [1, 2, 50, 127] {
        let mut losses: Losses<2> = Losses::new();
        let before = 255_u8.wrapping_sub(gap);
        assert_eq!(
            arrivals(&mut losses, 1, &[before, 0, 1]),
            [Arrival::First, Arrival::Gap(gap), Arrival::Next],
            "{gap}"
        );
        assert_eq!((losses.total().lost, losses.total().restarts), (u64::from(gap), 0));
    }
}

#[test]
fn components_count_for_themselves_and_the_silent_one_is_forgotten() {
    let mut losses: Losses<2> = Losses::new();
    arrivals(&mut losses, 1, &[1, 3]);
    arrivals(&mut losses, 2, &[7, 8]);
    arrivals(&mut losses, 1, &[4]);
    assert_eq!((losses.total().received, losses.total().lost), (5, 1));
    assert_eq!(arrivals(&mut losses, 3, &[0]), [Arrival::First]);
    let mut components: Vec<_> = losses.iter().map(|sender| sender.component_id.to_u32()).collect();
    components.sort_unstable();
    assert_eq!(components, [1, 3]);
    assert_eq!(losses.of(1, 2), None);
}

#[test]
fn unverified_frames_count_only_where_a_verified_one_came_before() {
    let frame = |number| encoded(Sender::v2(1, 1), number, &Heartbeat::DEFAULT.into());
    let (unknown, mut losses) = (Table::of(&[]), Losses::<2>::new());
    assert_eq!(losses.count(&Frame::parse(&frame(0), &unknown).unwrap()), Arrival::Ignored);
    assert_eq!(losses.iter().count(), 0);
    arrivals(&mut losses, 1, &[1]);
    assert_eq!(losses.count(&Frame::parse(&frame(2), &unknown).unwrap()), Arrival::Next);
}

#[test]
fn radios_that_number_by_no_rule_are_left_out() {
    let bytes = encoded(Sender::v1(b'3', b'D'), 9, &Heartbeat::DEFAULT.into());
    let mut losses: Losses<2> = Losses::new();
    assert_eq!(losses.count(&Frame::parse(&bytes, Small::TABLE).unwrap()), Arrival::Ignored);
}

#[test]
fn a_tracker_without_room_counts_nothing() {
    assert_eq!(arrivals(&mut Losses::<0>::new(), 1, &[0, 1]), [Arrival::Ignored; 2]);
}

proptest! {
    /// However many are lost at random, the counts are right, and no restart is made up.
    #[test]
    fn random_losses_are_counted(kept in proptest::collection::vec(proptest::bool::weighted(0.5), 300)) {
        let mut losses = Losses::<1>::new();
        let arrived: Vec<u8> = (0..=255_u8).cycle().zip(&kept).filter(|(_, kept)| **kept).map(|(number, _)| number).collect();
        arrivals(&mut losses, 1, &arrived);
        let first = kept.iter().position(|kept| *kept).unwrap_or(kept.len());
        let last = kept.iter().rposition(|kept| *kept).map_or(first, |last| last + 1);
        let lost = kept[first..last].iter().filter(|kept| !**kept).count() as u64;
        prop_assert_eq!((losses.total().lost, losses.total().restarts), (lost, 0));
    }

    /// pymavlink's `mav_loss`: every difference is a loss.
    #[test]
    fn in_order_the_counts_are_those_of_pymavlink(gaps in proptest::collection::vec(0..230_u8, 1..60)) {
        let (mut losses, mut number, mut lost) = (Losses::<1>::new(), 0_u8, 0_u64);
        arrivals(&mut losses, 1, &[number]);
        for gap in gaps {
            // A number of zero behind a long gap is a start of the sender.
            let gap = if gap >= 128 && number.wrapping_add(gap) == 255 { 0 } else { gap };
            number = number.wrapping_add(1).wrapping_add(gap);
            lost += u64::from(gap);
            arrivals(&mut losses, 1, &[number]);
        }
        prop_assert_eq!(losses.total().lost, lost);
        prop_assert_eq!(losses.total().late + losses.total().duplicates + losses.total().restarts, 0);
    }
}
