/**
 * What can be seen of a stopped program and its robot, now or at a moment of the past, as values
 * that are looked at piece by piece. {@link org.pendant.editors.dap.look.Shown} is the class to
 * open first.
 */
package org.pendant.editors.dap.look;
