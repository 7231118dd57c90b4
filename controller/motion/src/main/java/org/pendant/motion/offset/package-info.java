/**
 * What carries the TCP aside from the path of moves by a program's wish: conveyors ({@link
 * org.pendant.motion.offset.ConveyorTracking}) and path offsets ({@link
 * org.pendant.motion.offset.PathOffsetting}).
 */
package org.pendant.motion.offset;
