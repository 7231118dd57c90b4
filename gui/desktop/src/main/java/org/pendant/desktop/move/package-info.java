/**
 * Move screen: moves the arm by hand: jog pads, joints, poses, tool and payload. Open {@link
 * org.pendant.desktop.move.MovePresenter} first, then {@link org.pendant.desktop.move.MoveView}.
 */
package org.pendant.desktop.move;
