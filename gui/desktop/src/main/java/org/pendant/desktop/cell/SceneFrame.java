package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import org.pendant.controller.world.Vector3;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SessionMember;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** Scene frame: what places in a scene are in: the base of the only arm, or a cell of several. */
final class SceneFrame {
  private SceneFrame() {}

  /** The frame of a scene, for people. */
  static String words(SceneDraft draft) {
    return draft.controllers().isEmpty() ? text("inTheBase") : text("inTheCell");
  }

  /**
   * Where the TCP of the arm that the window shows is in its cell, m; the first where it is none.
   */
  static Vector3 tcpM(RobotSession session) {
    SessionMember shown = session.shown();
    SessionMember of = shown.armless() ? session.members().getFirst() : shown;
    Pose tcp = Poses.trans(of.baseInCell(), of.state().arm().targetTcpInBase());
    return new Vector3(tcp.x(), tcp.y(), tcp.z());
  }
}
