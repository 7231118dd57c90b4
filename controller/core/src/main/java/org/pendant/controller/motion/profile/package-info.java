/**
 * Distance over time along a path, whatever the path is: speeds, accelerations and jerks within
 * limits. Open {@link org.pendant.controller.motion.profile.ProfileLimits} first.
 */
package org.pendant.controller.motion.profile;
