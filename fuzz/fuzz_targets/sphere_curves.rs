#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| splitstar_fuzz::check_sphere_curves(bytes));
