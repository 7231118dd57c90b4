package org.pendant.desktop.shell;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.kit.settings.Settings;
import org.pendant.recording.lines.Margin;

/** Scene options: what people want to see besides the arm; kept from one start to the next. */
final class SceneShows {
  private static final String FRAMES = "scene.frames";
  private static final String PAYLOAD = "scene.payload";
  private static final String FEATURES = "scene.features";
  private static final String TRACE = "scene.trace";
  private static final String ELBOW = "scene.trace-elbow";
  private static final String TRACE_BY = "scene.trace-by";
  private static final String WAYPOINTS = "scene.waypoints";
  private static final String PLANES = "scene.safety-planes";
  private static final String DIRECTION = "scene.safety-direction";
  private static final String JOINT_RANGE = "scene.safety-joints";
  private static final String REACH = "scene.safety-reach";

  private final Settings settings;

  SceneShows(Settings settings) {
    this.settings = settings;
  }

  /** The frames of the joints and the flange. */
  boolean frames() {
    return on(FRAMES, false);
  }

  void setFrames(boolean on) {
    settings.put(FRAMES, Boolean.toString(on));
  }

  /** A ball for the payload. */
  boolean payload() {
    return on(PAYLOAD, false);
  }

  void setPayload(boolean on) {
    settings.put(PAYLOAD, Boolean.toString(on));
  }

  /** The features of the installation. */
  boolean features() {
    return on(FEATURES, true);
  }

  void setFeatures(boolean on) {
    settings.put(FEATURES, Boolean.toString(on));
  }

  /** Where the tool was. */
  boolean trace() {
    return on(TRACE, true);
  }

  void setTrace(boolean on) {
    settings.put(TRACE, Boolean.toString(on));
  }

  /** Where the elbow was, beside where the tool was. */
  boolean elbow() {
    return on(ELBOW, false);
  }

  void setElbow(boolean on) {
    settings.put(ELBOW, Boolean.toString(on));
  }

  /** The margin that the way of the tool is coloured by; empty for its speed. */
  Optional<Margin> traceBy() {
    return settings
        .get(TRACE_BY)
        .flatMap(
            name ->
                Arrays.stream(Margin.values()).filter(each -> each.name().equals(name)).findAny());
  }

  void setTraceBy(Optional<Margin> margin) {
    settings.put(TRACE_BY, margin.map(Margin::name).orElse(""));
  }

  /** The places that the program in front goes to. */
  boolean waypoints() {
    return on(WAYPOINTS, true);
  }

  void setWaypoints(boolean on) {
    settings.put(WAYPOINTS, Boolean.toString(on));
  }

  /** The safety planes. */
  boolean planes() {
    return on(PLANES, true);
  }

  void setPlanes(boolean on) {
    settings.put(PLANES, Boolean.toString(on));
  }

  /** Where the tool may point. */
  boolean direction() {
    return on(DIRECTION, true);
  }

  void setDirection(boolean on) {
    settings.put(DIRECTION, Boolean.toString(on));
  }

  /** The range of the joint that is nearest to its limit. */
  boolean jointRange() {
    return on(JOINT_RANGE, false);
  }

  void setJointRange(boolean on) {
    settings.put(JOINT_RANGE, Boolean.toString(on));
  }

  /** How far the arm reaches. */
  boolean reach() {
    return on(REACH, false);
  }

  void setReach(boolean on) {
    settings.put(REACH, Boolean.toString(on));
  }

  private boolean on(String name, boolean usually) {
    return settings.get(name).map(Boolean::parseBoolean).orElse(usually);
  }
}
