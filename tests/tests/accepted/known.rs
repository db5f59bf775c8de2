//! What mavgen accepts today and should not, or should print otherwise.

/// Seeds by the fault that they show. One that compiles has to leave the list.
pub(crate) const KNOWN: &[(&[u64], &str)] = &[
    (
        &[16, 18, 21, 39, 50, 62, 63, 73, 81, 87, 90, 107, 137, 140, 144],
        "the helper `store_…` of slots beside a getter of that name",
    ),
    (&[6], "a type called `Iterator`"),
    (&[38, 42, 48, 49, 52, 53, 66, 69, 74, 133, 139], "a member called like a method of a trait: `eq`, `fmt`, `into`"),
    (&[22], "a getter `len` without `is_empty`, for clippy"),
    (&[82], "a getter called like a method of a standard trait, for clippy"),
];

/// Whether it is known that this one fails.
pub(crate) fn is_known(seed: u64) -> bool {
    KNOWN.iter().any(|(seeds, _)| seeds.contains(&seed))
}
