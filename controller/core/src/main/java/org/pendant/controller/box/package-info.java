/**
 * The control box: every part that the frame loop owns, in one place. Open {@link
 * org.pendant.controller.box.ControlBox} first.
 */
package org.pendant.controller.box;
