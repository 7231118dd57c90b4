/**
 * The screen that moves the arm by hand: jog pads, joints, poses, tool and payload. Open {@link
 * org.pendant.gui.move.MovePresenter} first, then {@link org.pendant.gui.move.MoveView}.
 */
package org.pendant.gui.move;
