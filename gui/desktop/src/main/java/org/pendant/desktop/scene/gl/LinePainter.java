package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4fc;
import org.pendant.controller.world.SceneObject;
import org.pendant.desktop.scene.BeltOutlines;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.desktop.scene.DeviceOutlines;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.Ground;
import org.pendant.desktop.scene.SafetyOutlines;
import org.pendant.desktop.scene.SafetySight;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.mesh.BoxEdges;
import org.pendant.desktop.scene.mesh.Finish;
import org.pendant.desktop.scene.mesh.FloorGrid;
import org.pendant.desktop.scene.mesh.FloorScale;
import org.pendant.desktop.scene.mesh.Lines;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Line painter: draws the lines of a model: the trace, the edges of boxes, the metres on the floor.
 */
final class LinePainter implements AutoCloseable {
  private static final float TRACE_PX_AT_800 = 2.6f;
  private static final float EDGE_PX_AT_800 = 1.3f;
  private static final float SAFETY_PX_AT_800 = 1.7f;
  private static final float COMPARED_PX_AT_800 = 2.2f;
  private static final float MIN_TRACE_PX = 1.5f;
  private static final float MIN_EDGE_PX = 1.1f;
  private static final float HIDDEN_TRACE_OPACITY = 0.16f;
  private static final float HIDDEN_WAY_OPACITY = 0.3f;
  private static final float EDGE_OPACITY = 0.75f;
  private static final float SCALE_OPACITY = 0.85f;

  private final ShaderProgram line;
  private final LineStrip trace = new LineStrip();
  private final LineStrip edges = new LineStrip();
  private final LineStrip scale = new LineStrip();
  private final LineStrip ways = new LineStrip();
  private final LineStrip safety = new LineStrip();
  private final LineStrip sensors = new LineStrip();
  private final LineStrip belts = new LineStrip();
  private final List<LineStrip> compared = new ArrayList<>();
  private ComparedWays comparedNow = ComparedWays.NONE;
  private TcpTrace tracedNow = TcpTrace.EMPTY;
  private Optional<EdgesOf> edged = Optional.empty();
  private Optional<ScaleOf> scaled = Optional.empty();
  private Optional<WaysOf> waysNow = Optional.empty();
  private Optional<SafetyOf> safetyNow = Optional.empty();
  private Optional<SensorsOf> sensorsNow = Optional.empty();
  private Optional<BeltsOf> beltsNow = Optional.empty();

  private record EdgesOf(Object world, Object touched, SceneTheme theme) {}

  private record WaysOf(WaypointMarkers marks, SceneTheme theme) {}

  private record SensorsOf(
      List<DeviceSight.Sensor> sensors,
      List<DeviceSight.CameraView> views,
      Pose cellInBase,
      SceneTheme theme) {}

  private record BeltsOf(
      List<DeviceSight.Belt> belts, List<Optional<SceneObject.Box>> boxes, SceneTheme theme) {}

  private record SafetyOf(
      SafetySight sight, String armId, Joints positionRad, Pose tcpInFlange, SceneTheme theme) {}

  private record ScaleOf(
      FloorGrid grid, double reachM, double heightM, int quarters, SceneTheme theme) {}

  LinePainter(Shaders shaders) {
    line = shaders.line();
  }

  /**
   * Draws what the depths that were drawn before leave to be seen.
   *
   * @param ground the floor; the scale on it is drawn where its upper side is seen
   */
  void draw(
      SceneModel model, Ground ground, Camera camera, Matrix4fc toClip, int width, int height) {
    load(model, ground, camera);
    Surroundings.blend();
    glDisable(GL_CULL_FACE);
    glDepthMask(false);
    line.use().set("toClip", toClip);
    line.set("halfPixels", width / 2f, height / 2f);
    line.set("width", Math.max(MIN_EDGE_PX, EDGE_PX_AT_800 * height / 800f));
    if (camera.looksDownOn(ground.heightM())) {
      line.set("opacity", SCALE_OPACITY);
      scale.draw();
    }
    line.set("opacity", EDGE_OPACITY);
    edges.draw();
    belts.draw();
    ways.draw();
    line.set("width", Math.max(MIN_EDGE_PX, SAFETY_PX_AT_800 * height / 800f));
    line.set("opacity", 1);
    safety.draw();
    sensors.draw();
    line.set("width", Math.max(MIN_TRACE_PX, TRACE_PX_AT_800 * height / 800f));
    line.set("opacity", 1);
    trace.draw();
    drawCompared(height);
    glDepthFunc(GL_GREATER);
    line.set("opacity", HIDDEN_TRACE_OPACITY);
    trace.draw();
    line.set("opacity", HIDDEN_WAY_OPACITY);
    drawCompared(height);
    line.set("width", Math.max(MIN_EDGE_PX, EDGE_PX_AT_800 * height / 800f));
    line.set("opacity", HIDDEN_WAY_OPACITY);
    ways.draw();
    safety.draw();
    sensors.draw();
    glDepthFunc(GL_LESS);
    glDepthMask(true);
  }

  private void drawCompared(int height) {
    for (int i = 0; i < compared.size(); i++) {
      float px = COMPARED_PX_AT_800 * (float) comparedNow.width(i);
      line.set("width", Math.max(MIN_TRACE_PX, px * height / 800f));
      compared.get(i).draw();
    }
  }

  private void loadCompared(ComparedWays wanted) {
    if (wanted.ways().equals(comparedNow.ways())) {
      return;
    }
    comparedNow = wanted;
    compared.forEach(LineStrip::close);
    compared.clear();
    for (ComparedWays.Way each : wanted.drawn()) {
      LineStrip strip = new LineStrip();
      strip.load(wanted.lines(each));
      compared.add(strip);
    }
  }

  private void load(SceneModel model, Ground ground, Camera camera) {
    if (model.trace() != tracedNow) {
      tracedNow = model.trace();
      trace.load(LineStrip.lines(tracedNow));
    }
    loadCompared(model.compared());
    SceneTheme theme = model.theme();
    EdgesOf newEdges = new EdgesOf(model.world(), model.touched(), theme);
    if (!edged.equals(Optional.of(newEdges))) {
      edged = Optional.of(newEdges);
      edges.load(
          BoxEdges.of(
              model.world().objects(),
              model.touched(),
              theme.edgeRgb(),
              theme.rgb(Finish.TOUCHED)));
    }
    WaysOf newWays = new WaysOf(model.waypointMarkers(), theme);
    if (!waysNow.equals(Optional.of(newWays))) {
      waysNow = Optional.of(newWays);
      ways.load(newWays.marks().lines(theme));
    }
    SafetyOf newSafety =
        new SafetyOf(
            model.safety(), model.arm().id(), model.positionRad(), model.tcpInFlange(), theme);
    if (!safetyNow.equals(Optional.of(newSafety))) {
      safetyNow = Optional.of(newSafety);
      safety.load(SafetyOutlines.of(model));
    }
    SensorsOf newSensors =
        new SensorsOf(
            model.devices().sensors(),
            model.devices().views(),
            model.devices().cellInBase(),
            theme);
    if (!sensorsNow.equals(Optional.of(newSensors))) {
      sensorsNow = Optional.of(newSensors);
      sensors.load(DeviceOutlines.of(model.devices(), theme));
    }
    loadBelts(model);
    ScaleOf newScale =
        new ScaleOf(
            model.grid(),
            Surroundings.FLOOR_REACH * model.arm().reachM(),
            ground.heightM(),
            FloorScale.quarters(camera.azimuthRad()),
            theme);
    if (!scaled.equals(Optional.of(newScale))) {
      scaled = Optional.of(newScale);
      scale.load(scale(newScale));
    }
  }

  private void loadBelts(SceneModel model) {
    List<DeviceSight.Belt> all = model.devices().belts();
    List<SceneObject> objects = model.world().objects();
    BeltsOf wanted =
        new BeltsOf(
            all, all.stream().map(each -> BeltOutlines.box(each, objects)).toList(), model.theme());
    if (!beltsNow.equals(Optional.of(wanted))) {
      beltsNow = Optional.of(wanted);
      belts.load(BeltOutlines.of(all, objects, model.theme()));
    }
  }

  private static Lines scale(ScaleOf of) {
    return FloorScale.of(
        of.grid(),
        of.reachM(),
        of.heightM(),
        of.quarters(),
        of.theme().rgb(Finish.AXIS_X),
        of.theme().rgb(Finish.AXIS_Y));
  }

  @Override
  public void close() {
    trace.close();
    edges.close();
    scale.close();
    ways.close();
    safety.close();
    sensors.close();
    belts.close();
    compared.forEach(LineStrip::close);
  }
}
