/**
 * Force control: pressing with a force instead of following the path alone, and noticing that the
 * tool has met something. Open {@link org.pendant.motion.force.ForceMode} first.
 */
package org.pendant.motion.force;
