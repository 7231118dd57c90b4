/**
 * Dynamics of the arms: torques that a motion needs and motions that torques give. Open {@link
 * org.pendant.models.dynamics.ArmDynamics} first.
 */
package org.pendant.models.dynamics;
