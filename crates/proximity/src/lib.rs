//! Proximity of polytopes: relation, separation distance and penetration depth, exactly.
