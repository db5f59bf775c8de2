//! Writes cases into folders: `random-dialects dialects|mutants FIRST COUNT OUT` makes OUT/SEED for each.

use std::error::Error;
use std::fs;
use std::path::Path;

use random_dialects::{case, mutant};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [kind, first, count, out] = arguments.as_slice() else {
        return Err("usage: random-dialects dialects|mutants FIRST COUNT OUT".into());
    };
    let (first, count): (u64, u64) = (first.parse()?, count.parse()?);
    for seed in first..first + count {
        let made = if kind == "mutants" { mutant(seed) } else { case(seed) };
        let folder = Path::new(out).join(seed.to_string());
        fs::create_dir_all(&folder)?;
        for (name, text) in made.files {
            fs::write(folder.join(name), text)?;
        }
    }
    Ok(())
}
