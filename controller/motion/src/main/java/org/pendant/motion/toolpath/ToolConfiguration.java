package org.pendant.motion.toolpath;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.ToolCurve;

/**
 * Tool configuration: whether the arm holds the tool or the part (manual 20.6). Poses of toolpaths
 * are in the work frame: the base frame when the arm holds the tool, the flange frame when it holds
 * the part. The tool's z-axis points from its tip into the tool.
 *
 * @param remote whether the tool stands still and the arm carries the part
 * @param tcp of the tool: in the flange frame, or in the base frame when it stands still
 */
public record ToolConfiguration(boolean remote, Pose tcp) {

  /** The place of the tool in the work frame when the flange is at {@code flange} in the base. */
  Pose toolAt(Pose flange) {
    return remote ? Poses.trans(Poses.inverse(flange), tcp) : Poses.trans(flange, tcp);
  }

  /** The flange in the base frame when the tool is at {@code tool} in the work frame. */
  Pose flangeAt(Pose tool) {
    return remote ? Poses.trans(tcp, Poses.inverse(tool)) : Poses.trans(tool, Poses.inverse(tcp));
  }

  /** What has to follow {@link #curve}, in the flange frame. */
  Pose followerInFlange() {
    return remote ? Pose.ZERO : tcp;
  }

  /** The way in the base frame of what has to follow, for a way of the tool in the work frame. */
  ToolCurve curve(ToolCurve inWork) {
    return remote ? new RemoteTcpCurve(inWork, tcp) : inWork;
  }

  /** How far two places of the flange are from each other where the tool is, m. */
  public double apartM(Pose flange, Pose other) {
    return Poses.pointDistance(toolAt(flange), toolAt(other));
  }

  /** The transformation of the flange for one of the tool in the work frame. */
  Mapping mapping() {
    double[] tool = new double[Transforms.SIZE];
    double[] inverse = new double[Transforms.SIZE];
    Transforms.of(tcp, tool);
    Transforms.invert(tool, inverse);
    double[] scratch = new double[Transforms.SIZE];
    return remote
        ? (inWork, flange) -> {
          Transforms.invert(inWork, scratch);
          Transforms.multiply(tool, scratch, flange);
        }
        : (inWork, flange) -> Transforms.multiply(inWork, inverse, flange);
  }

  /** As {@link #flangeAt}, without allocating. */
  @FunctionalInterface
  interface Mapping {
    void flange(double[] inWork, double[] flange);
  }
}
