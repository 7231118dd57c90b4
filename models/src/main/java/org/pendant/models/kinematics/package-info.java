/**
 * Kinematics of the arms: from joints to poses and speeds, and back. Open {@link
 * org.pendant.models.kinematics.ForwardKinematics} first.
 */
package org.pendant.models.kinematics;
