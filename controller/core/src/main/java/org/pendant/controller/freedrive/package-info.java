/**
 * Freedrive: the arm is guided by hand, along all axes or some (manual 15.18). Open {@link
 * org.pendant.controller.freedrive.Freedrive} first, then {@link
 * org.pendant.controller.freedrive.AxisConstraint}, which holds the axes that are not free.
 */
package org.pendant.controller.freedrive;
