package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Ball;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.GripperPlaces;
import org.pendant.desktop.scene.Ground;
import org.pendant.desktop.scene.LinkPlaces;
import org.pendant.desktop.scene.OtherArm;
import org.pendant.desktop.scene.SafetyColours;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.Sheets;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.mesh.ArmMeshes;
import org.pendant.desktop.scene.mesh.Detail;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.Joints;
import org.pendant.models.collision.LinkCapsules;
import org.pendant.models.pose.Pose;

/**
 * Scene renderer: draws models with the context that is current on the calling thread: a dozen
 * calls a picture, all meshes in the memory of the graphics, the shadow again only when a body has
 * moved.
 */
final class SceneRenderer implements AutoCloseable {
  private static final Vector3f TO_SUN = new Vector3f(0.42f, -0.62f, 1.05f).normalize();
  private static final String TOOL = LinkCapsules.name(LinkCapsules.TOOL);
  private static final Vector3f NO_TINT = new Vector3f();
  private static final int LIT_RGB = 0xFFC400;
  private static final int UNLIT_RGB = 0x6B6352;
  private static final int GHOST_RGB = 0x3B82D9;
  private static final float GHOST_OPACITY = 0.38f;

  /** How far beyond the arm's reach there are shadows. */
  private static final float LIT_SHARE = 1.25f;

  /** About two pixels of the shadow's map. */
  private static final float SHADOW_OFFSET_SHARE = 0.006f;

  /** Extra frames are smaller than those of base and tool. */
  private static final float EXTRA_FRAME_SHARE = 0.75f;

  private static final float MARK_SHARE = 0.32f;
  private static final float CHOSEN_MARK_SHARE = 0.6f;

  private static final float HIDDEN_FRAME_OPACITY = 0.45f;

  private final Shaders shaders = new Shaders();
  private final ShadowMap shadow = new ShadowMap();
  private final Surroundings surroundings = new Surroundings(shaders);
  private final LinePainter lines = new LinePainter(shaders);
  private final Map<Detail, Bodies> bodies = new EnumMap<>(Detail.class);
  private Optional<Canvas> canvas = Optional.empty();
  private Optional<ShadowCaster> inShadow = Optional.empty();

  private record ShadowCaster(
      String armId,
      Joints positionRad,
      Object world,
      Object grippers,
      Pose tcpInFlange,
      List<OtherArm> others,
      Detail detail) {}

  /** Another arm, and where its links and grippers are. */
  private record Other(OtherArm arm, LinkPlaces places, List<List<Matrix4f>> gripperPlaces) {
    static Other of(OtherArm arm) {
      LinkPlaces places = arm.places();
      return new Other(arm, places, arm.gripperPlaces(places));
    }
  }

  /** What stays the same while one picture is drawn. */
  private record Sight(
      SceneModel model,
      Camera camera,
      Quality quality,
      Bodies bodies,
      LinkPlaces places,
      List<List<Matrix4f>> gripperPlaces,
      List<Other> others,
      Ground ground,
      Matrix4fc toClip,
      Matrix4fc toMap) {}

  /**
   * Draws one picture.
   *
   * @param pixels {@code width * height} numbers 0xAARRGGBB from the top left corner, overwritten
   */
  void render(
      SceneModel model, Camera camera, Quality quality, int width, int height, int[] pixels) {
    Matrix4f toShadow = ShadowMap.toClip(lit(model), TO_SUN);
    // Upside down, so that the first row that is read is the top one.
    Matrix4f toClip =
        new Matrix4f().scale(1, -1, 1).mul(camera.projection((double) width / height));
    LinkPlaces places = new LinkPlaces(model.kinematics(), model.arm().dh(), model.positionRad());
    Sight sight =
        new Sight(
            model,
            camera,
            quality,
            loaded(quality.detail(), model),
            places,
            GripperPlaces.of(model, places),
            model.others().stream().map(Other::of).toList(),
            Ground.of(model),
            toClip,
            ShadowMap.toMap(toShadow));
    glEnable(GL_DEPTH_TEST);
    glDepthMask(true);
    castShadow(sight, toShadow);
    Canvas target = canvas(width, height, quality);
    target.begin();
    shadow.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_BLEND);
    drawBodies(sight, useSolid(sight));
    drawSurroundings(sight, target.drawnHeight());
    List<Sheets.Sheet> sheets = Sheets.of(model, sight.ground, camera.eyeM());
    drawSheets(sight, sheets.stream().filter(Sheets.Sheet::behind).toList());
    lines.draw(model, sight.ground, camera, toClip, target.drawnWidth(), target.drawnHeight());
    drawHiddenFrames(sight);
    drawGhosts(sight);
    drawSheets(sight, sheets.stream().filter(sheet -> !sheet.behind()).toList());
    target.read(pixels);
  }

  /** The meshes of the arm of the model that was drawn last, or of this one. */
  ArmMeshes armMeshes(SceneModel model) {
    return loaded(Detail.COARSE, model).armMeshes();
  }

  private Bodies loaded(Detail detail, SceneModel model) {
    Bodies wanted = bodies.computeIfAbsent(detail, Bodies::new);
    wanted.load(model);
    return wanted;
  }

  private Canvas canvas(int width, int height, Quality quality) {
    if (canvas.isEmpty() || !canvas.get().is(width, height, quality)) {
      canvas.ifPresent(Canvas::close);
      canvas = Optional.of(new Canvas(width, height, quality));
    }
    return canvas.get();
  }

  private static Ball lit(SceneModel model) {
    Ball reach = Ball.reach(model);
    return new Ball(reach.centreM(), LIT_SHARE * reach.radiusM());
  }

  private void castShadow(Sight sight, Matrix4fc toShadow) {
    SceneModel model = sight.model;
    ShadowCaster caster =
        new ShadowCaster(
            model.arm().id(),
            model.positionRad(),
            model.world(),
            model.devices().grippers(),
            model.tcpInFlange(),
            model.others(),
            sight.quality.detail());
    if (inShadow.equals(Optional.of(caster))) {
      return;
    }
    inShadow = Optional.of(caster);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    shadow.begin();
    ShaderProgram depth = shaders.depth();
    depth.use().set("toClip", toShadow);
    place(depth, sight.places);
    sight.bodies.arm().draw();
    depth.set("places", 0, new Matrix4f());
    sight.bodies.world().draw();
    drawTool(depth, sight.places, sight.bodies.tool(model.world().toolBodies()), List.of());
    drawGrippers(sight, depth);
    drawOthers(sight, depth);
    shadow.end();
  }

  private void drawSurroundings(Sight sight, int height) {
    SceneModel model = sight.model;
    Shadows shadows = sight.quality.shadows();
    float reachM = (float) model.arm().reachM();
    ShadowReach reach = new ShadowReach(TO_SUN, (float) sight.ground.heightM(), LIT_SHARE * reachM);
    sight.bodies.addTo(reach, sight.places, sight.gripperPlaces);
    for (Other each : sight.others) {
      sight.bodies.addTo(reach, each.arm, each.places, each.gripperPlaces);
    }
    float[] shaded = reach.rectangle(2 * SHADOW_OFFSET_SHARE * reachM);
    boolean fromAbove = sight.camera.looksDownOn(sight.ground.heightM());
    if (!fromAbove) {
      surroundings.drawSky(model.theme());
    }
    surroundings.drawFloor(
        model, sight.ground, sight.toClip, sight.toMap, fromAbove ? height : 0, shadows, shaded);
    if (fromAbove) {
      surroundings.drawSky(model.theme());
    }
  }

  private void drawSheets(Sight sight, List<Sheets.Sheet> sheets) {
    surroundings.drawSheets(
        sheets, sight.model, sight.toClip, sight.toMap, sight.quality.shadows());
  }

  private ShaderProgram useSolid(Sight sight) {
    SceneModel model = sight.model;
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);
    boolean light = model.theme() == SceneTheme.LIGHT;
    ShaderProgram solid = shaders.solid(sight.quality.shadows());
    solid.use().set("toClip", sight.toClip);
    solid.set("toLight", sight.toMap);
    solid.setAll("finishes", Paints.finishes(model.theme()));
    solid.set("eye", vector(sight.camera.eyeM()));
    solid.set("toSun", TO_SUN);
    solid.set("sunlight", light ? 0.80f : 0.78f);
    solid.set(
        "sky", light ? new Vector3f(0.40f, 0.43f, 0.48f) : new Vector3f(0.22f, 0.245f, 0.28f));
    solid.set(
        "ground",
        light ? new Vector3f(0.20f, 0.197f, 0.193f) : new Vector3f(0.06f, 0.062f, 0.068f));
    solid.set("tint", NO_TINT, 0);
    solid.setBits("hit", 0);
    solid.set("hitColour", Paints.linear(SafetyColours.forbiddenRgb(model.theme())));
    solid.set("opacity", 1);
    solid.set("shadowOffset", SHADOW_OFFSET_SHARE * (float) model.arm().reachM());
    solid.set("floorHeight", (float) sight.ground.heightM());
    solid.setTexture("shadowMap", 0);
    return solid;
  }

  private static void drawBodies(Sight sight, ShaderProgram solid) {
    SceneModel model = sight.model;
    Bodies bodies = sight.bodies;
    place(solid, sight.places);
    solid.setBits("hit", bits(model.safety().hitLinks()));
    bodies.arm().draw();
    solid.setBits("hit", 0);
    solid.set("places", 0, new Matrix4f());
    bodies.world().draw();
    drawTool(
        solid, sight.places, bodies.tool(model.world().toolBodies()), model.safety().hitLinks());
    drawGrippers(sight, solid);
    drawOthers(sight, solid);
    float length = frameLengthM(model);
    Matrix4f tcp = LinkPlaces.matrix(model.tcpInBase());
    drawFrame(sight, solid, new Matrix4f(), length);
    drawFrame(sight, solid, tcp, length);
    for (Pose frame : model.framesInBase()) {
      drawFrame(sight, solid, LinkPlaces.matrix(frame), EXTRA_FRAME_SHARE * length);
    }
    for (WaypointMarkers.Mark mark : model.waypointMarkers().marks()) {
      float share = mark.chosen() ? CHOSEN_MARK_SHARE : MARK_SHARE;
      drawFrame(sight, solid, LinkPlaces.matrix(mark.inBase()), share * length);
    }
    if (model.devices().grippers().isEmpty() && model.world().toolBodies().isEmpty()) {
      drawRod(sight, solid, new Matrix4f(sight.places.of(Link.WRIST_3)), tcp);
    }
    model.payload().ifPresent(ball -> drawBall(sight, solid, ball));
    drawLamps(sight, solid);
  }

  /** All that is on the flange is one mesh, in place 0. A shadow has no colour for what was hit. */
  private static void drawTool(
      ShaderProgram program, LinkPlaces places, GpuMesh tool, List<String> hitLinks) {
    program.set("places", 0, new Matrix4f(places.of(Link.WRIST_3)));
    program.setBits("hit", hitLinks.contains(TOOL) ? 1 : 0);
    tool.draw();
    program.setBits("hit", 0);
  }

  private static void drawGrippers(Sight sight, ShaderProgram program) {
    for (int gripper = 0; gripper < sight.gripperPlaces.size(); gripper++) {
      List<Matrix4f> places = sight.gripperPlaces.get(gripper);
      for (int i = 0; i < places.size(); i++) {
        program.set("places", i, places.get(i));
      }
      sight.bodies.gripper(gripper).draw();
    }
  }

  private static void drawOthers(Sight sight, ShaderProgram program) {
    for (Other other : sight.others) {
      place(program, other.places);
      program.setBits("hit", bits(other.arm.hitLinks()));
      sight.bodies.arm(other.arm).draw();
      drawTool(
          program, other.places, sight.bodies.tool(other.arm.toolBodies()), other.arm.hitLinks());
      for (int gripper = 0; gripper < other.gripperPlaces.size(); gripper++) {
        List<Matrix4f> places = other.gripperPlaces.get(gripper);
        for (int i = 0; i < places.size(); i++) {
          program.set("places", i, places.get(i));
        }
        sight.bodies.gripper(other.arm, gripper).draw();
      }
    }
  }

  private static float frameLengthM(SceneModel model) {
    return (float) (0.05 + 0.1 * model.arm().reachM());
  }

  /** Frames of joints lie inside of the arm; they shine through it. */
  private void drawHiddenFrames(Sight sight) {
    if (sight.model.framesInBase().isEmpty()) {
      return;
    }
    ShaderProgram solid = useSolid(sight);
    solid.set("opacity", HIDDEN_FRAME_OPACITY);
    Surroundings.blend();
    glDepthMask(false);
    glDepthFunc(GL_GREATER);
    for (Pose frame : sight.model.framesInBase()) {
      Matrix4f place = LinkPlaces.matrix(frame);
      drawFrame(sight, solid, place, EXTRA_FRAME_SHARE * frameLengthM(sight.model));
    }
    glDepthFunc(GL_LESS);
    glDepthMask(true);
    glDisable(GL_BLEND);
  }

  private static void drawFrame(Sight sight, ShaderProgram solid, Matrix4f frame, float lengthM) {
    solid.set("places", 0, frame.scale(lengthM, new Matrix4f()));
    sight.bodies.frame().draw();
  }

  private static void drawBall(Sight sight, ShaderProgram solid, Ball ball) {
    Matrix4f place = new Matrix4f().translation(vector(ball.centreM()));
    solid.set("places", 0, place.scale((float) ball.radiusM()));
    sight.bodies.ball().draw();
  }

  /** A lamp that is lit has a colour that light does not change. */
  private static void drawLamps(Sight sight, ShaderProgram solid) {
    for (DeviceSight.Lamp lamp : sight.model.devices().lamps()) {
      solid.set("tint", Paints.linear(lamp.lit() ? LIT_RGB : UNLIT_RGB), lamp.lit() ? 1 : 0.7f);
      Pose at = lamp.inBase();
      Vector3 centreM = new Vector3(at.x(), at.y(), at.z());
      drawBall(sight, solid, new Ball(centreM, DeviceSight.Lamp.RADIUS_M));
      solid.set("tint", NO_TINT, 0);
    }
  }

  /** From the flange to the tool centre point, so that it is clear what carries it. */
  private static void drawRod(Sight sight, ShaderProgram solid, Matrix4f flange, Matrix4f tcp) {
    Vector3f from = flange.getTranslation(new Vector3f());
    Vector3f way = tcp.getTranslation(new Vector3f()).sub(from);
    float length = way.length();
    if (length > 1e-4f) {
      Matrix4f place = new Matrix4f().translation(from);
      place.rotateTowards(way.div(length), leastAlong(way));
      solid.set("places", 0, place.scale(1, 1, length));
      sight.bodies.rod().draw();
    }
  }

  private static Vector3f leastAlong(Vector3f direction) {
    return Math.abs(direction.z) < 0.7f ? new Vector3f(0, 0, 1) : new Vector3f(1, 0, 0);
  }

  /** Those of variants, and above them where the arm shall go. */
  private void drawGhosts(Sight sight) {
    SceneModel model = sight.model;
    Vector3 eye = sight.camera.eyeM();
    ComparedWays compared = model.compared();
    for (ComparedWays.Ghost each :
        compared.drawnGhosts(
            rad -> distanceM(eye, model.kinematics().tcpPose(rad, model.tcpInFlange())))) {
      drawGhost(sight, each.positionRad(), each.rgb(), (float) compared.opacity(each));
    }
    model.ghostRad().ifPresent(rad -> drawGhost(sight, rad, GHOST_RGB, GHOST_OPACITY));
  }

  private static double distanceM(Vector3 eye, Pose pose) {
    return Math.hypot(Math.hypot(eye.x() - pose.x(), eye.y() - pose.y()), eye.z() - pose.z());
  }

  /** Its depths first, so that no far side shines through the near one. */
  private void drawGhost(Sight sight, Joints positionRad, int rgb, float opacity) {
    SceneModel model = sight.model;
    ShaderProgram solid = useSolid(sight);
    glDisable(GL_BLEND);
    place(solid, new LinkPlaces(model.kinematics(), model.arm().dh(), positionRad));
    solid.set("tint", Paints.linear(rgb), 0.7f);
    solid.set("opacity", opacity);
    // Where both arms are in one place, the real one is in front.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 16);
    glColorMask(false, false, false, false);
    sight.bodies.arm().draw();
    glColorMask(true, true, true, true);
    Surroundings.blend();
    glDepthFunc(GL_LEQUAL);
    sight.bodies.arm().draw();
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
  }

  /** A bit for each link that is named. */
  private static int bits(List<String> links) {
    int bits = 0;
    for (Link each : Link.values()) {
      if (links.contains(each.name().toLowerCase(Locale.ROOT).replace('_', ' '))) {
        bits |= 1 << each.ordinal();
      }
    }
    return bits;
  }

  private static void place(ShaderProgram program, LinkPlaces places) {
    int number = 0;
    for (Link link : Link.values()) {
      program.set("places", number++, places.of(link));
    }
  }

  private static Vector3f vector(Vector3 v) {
    return new Vector3f((float) v.x(), (float) v.y(), (float) v.z());
  }

  @Override
  public void close() {
    canvas.ifPresent(Canvas::close);
    lines.close();
    surroundings.close();
    bodies.values().forEach(Bodies::close);
    shadow.close();
    shaders.close();
  }
}
