/**
 * Poses, rotations and wrenches as values, and the algebra of URScript's pose functions. Open
 * {@link org.pendant.models.pose.Poses} first.
 *
 * <p>Sines and cosines come from {@link java.lang.Math}, not {@link java.lang.StrictMath}. Runs
 * must be repeatable to the last bit, and they are: on the virtual machines we support, interpreter
 * and compilers call one and the same routine for these two functions (a test compares them), and
 * everything else used here (square root, arc tangent, arc sine) is defined exactly or has only one
 * implementation. StrictMath would make results equal between kinds of processor, too, but takes
 * 1.4 to 2 times as long when compiled and six times as long before, which short runs would feel.
 */
package org.pendant.models.pose;
