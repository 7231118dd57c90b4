/**
 * Motion profiles: distance over time along a path, whatever the path is, with speeds,
 * accelerations and jerks within limits. Open {@link org.pendant.motion.profile.ProfileLimits}
 * first.
 */
package org.pendant.motion.profile;
