//! Decimal digits: plain ASCII, whatever else counts as a digit in Unicode or for a standard parser, which takes a sign as well.

/// Whether a text is decimal digits and nothing else, at least one.
pub(crate) fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether a text is a year and a month, as `2018-04`.
pub(crate) fn is_year_and_month(text: &str) -> bool {
    text.split_once('-').is_some_and(|(year, month)| {
        year.len() == 4 && is_digits(year) && month.len() == 2 && is_digits(month) && ("01"..="12").contains(&month)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits() {
        assert!(is_digits("0") && is_digits("0123456789"));
        for text in ["", "-1", "+1", " 1", "1.0", "٣", "0x1"] {
            assert!(!is_digits(text), "{text}");
        }
    }

    #[test]
    fn dates() {
        for date in ["2018-04", "2026-12", "2026-01"] {
            assert!(is_year_and_month(date), "{date}");
        }
        for date in
            ["", "2018", "2018-4", "2018-13", "2018-00", "18-04", "2018-04-01", "April 2018", "２018-04", "2018-+4"]
        {
            assert!(!is_year_and_month(date), "{date}");
        }
    }
}
