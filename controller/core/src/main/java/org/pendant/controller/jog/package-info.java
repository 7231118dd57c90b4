/**
 * Jogging: moving the arm by hand, from a screen: it moves as long as it is told to. Open {@link
 * org.pendant.controller.jog.Jogging} first.
 */
package org.pendant.controller.jog;
