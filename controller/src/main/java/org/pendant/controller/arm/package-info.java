/**
 * Simulated arms: what the joints do when they are given targets. Open {@link
 * org.pendant.controller.arm.SimulatedArm} first.
 */
package org.pendant.controller.arm;
