/**
 * Path offsets of programs: conveyors ({@link org.pendant.motion.offset.ConveyorTracking}) and
 * offsets that a program adds ({@link org.pendant.motion.offset.PathOffsetting}).
 */
package org.pendant.motion.offset;
