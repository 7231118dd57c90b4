/**
 * Moving the arm by hand, from a screen: it moves as long as somebody says so. Open {@link
 * org.pendant.controller.jog.Jogging} first.
 */
package org.pendant.controller.jog;
