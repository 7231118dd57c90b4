package org.pendant.desktop.session;

import org.pendant.command.service.RobotAccess;

/** Session access: leads others to the controller of a session, also when it is exchanged. */
public final class SessionAccess implements SwitchListener {
  private final RobotAccess access;
  private final RobotSession session;

  private SessionAccess(RobotAccess access, RobotSession session) {
    this.access = access;
    this.session = session;
  }

  /** Leads to the controllers of a session from now on. */
  public static void lead(RobotAccess access, RobotSession session) {
    SessionAccess open = new SessionAccess(access, session);
    session.addSwitchListener(open);
    open.switchedOn();
  }

  @Override
  public void switchingOff() {
    access.hide();
  }

  @Override
  public void switchedOn() {
    access.show(session.robot(), session::programSource);
  }

  /** Others follow to the controller that is shown. */
  @Override
  public void shown() {
    access.hide();
    switchedOn();
  }
}
