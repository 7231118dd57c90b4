package org.pendant.desktop.session;

import org.pendant.controller.state.ControllerState;

/** Cell listener: sees every frame of each controller of a session, whichever is shown. */
@FunctionalInterface
public interface CellListener {
  /** A frame of a controller has ended; in the thread that drives it, and must be short. */
  void frame(SessionMember member, ControllerState state);
}
