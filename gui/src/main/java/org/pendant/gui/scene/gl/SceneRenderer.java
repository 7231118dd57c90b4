package org.pendant.gui.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.util.Optional;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.pendant.controller.world.Vector3;
import org.pendant.gui.scene.Ball;
import org.pendant.gui.scene.Camera;
import org.pendant.gui.scene.Ground;
import org.pendant.gui.scene.LinkPlaces;
import org.pendant.gui.scene.SceneModel;
import org.pendant.gui.scene.Theme;
import org.pendant.gui.scene.mesh.ArmMeshes;
import org.pendant.gui.scene.mesh.Finish;
import org.pendant.gui.scene.mesh.Link;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Draws models with the context that is current on the calling thread: a dozen calls a picture, all
 * meshes in the memory of the graphics, the shadow again only when a body has moved.
 */
final class SceneRenderer implements AutoCloseable {
  private static final Vector3f TO_SUN = new Vector3f(0.42f, -0.62f, 1.05f).normalize();
  private static final Vector3f NO_TINT = new Vector3f();
  private static final int GHOST_RGB = 0x3B82D9;

  /** About two pixels of the shadow's map. */
  private static final float SHADOW_OFFSET_SHARE = 0.006f;

  private static final float TRACE_PX_AT_800 = 2.6f;
  private static final float HIDDEN_TRACE_OPACITY = 0.16f;

  private final ShaderProgram solid = new ShaderProgram("solid");
  private final ShaderProgram depth = new ShaderProgram("depth");
  private final ShaderProgram plane = new ShaderProgram("plane");
  private final ShaderProgram sky = new ShaderProgram("sky");
  private final ShaderProgram trace = new ShaderProgram("trace");
  private final ShadowMap shadow = new ShadowMap();
  private final Bodies bodies = new Bodies();
  private final TraceStrip strip = new TraceStrip();

  /** The core profile draws nothing without one, also where there is no buffer. */
  private final int emptyArray = glGenVertexArrays();

  private Optional<Canvas> canvas = Optional.empty();
  private Optional<ShadowCaster> inShadow = Optional.empty();

  private record ShadowCaster(String armId, Joints positionRad, Object world) {}

  /**
   * Draws one picture.
   *
   * @param pixels {@code width * height} numbers 0xAARRGGBB from the top left corner, overwritten
   */
  void render(SceneModel model, Camera camera, int width, int height, int[] pixels) {
    bodies.load(model);
    strip.load(model.trace());
    Ball lit = lit(model);
    Matrix4f toShadow = ShadowMap.toClip(lit, TO_SUN);
    LinkPlaces places = new LinkPlaces(model.kinematics(), model.arm().dh(), model.positionRad());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(true);
    castShadow(model, places, toShadow);
    Canvas target = canvas(width, height);
    target.begin();
    shadow.bind();
    // Upside down, so that the first row that is read is the top one.
    Matrix4f toClip =
        new Matrix4f().scale(1, -1, 1).mul(camera.projection((double) width / height));
    Matrix4f toMap = ShadowMap.toMap(toShadow);
    Ground ground = Ground.of(model);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_BLEND);
    useSolid(model, camera, toClip, toMap, ground);
    drawBodies(model, places);
    boolean fromAbove = camera.eyeM().z() > ground.heightM();
    usePlane(model, toClip, toMap);
    if (fromAbove) {
      drawFloor(model, ground, height);
      drawSky(model.theme());
    } else {
      drawSky(model.theme());
      drawFloor(model, ground, 0);
    }
    drawPlanes(model, ground);
    drawTrace(toClip, width, height);
    useSolid(model, camera, toClip, toMap, ground);
    drawGhost(model);
    target.read(pixels);
  }

  /** The meshes of the arm of the model that was drawn last. */
  ArmMeshes armMeshes() {
    return bodies.armMeshes();
  }

  private Canvas canvas(int width, int height) {
    if (canvas.isEmpty() || !canvas.get().sized(width, height)) {
      canvas.ifPresent(Canvas::close);
      canvas = Optional.of(new Canvas(width, height));
    }
    return canvas.get();
  }

  private static Ball lit(SceneModel model) {
    Ball reach = Ball.reach(model);
    return new Ball(reach.centreM(), 1.25 * reach.radiusM());
  }

  private void castShadow(SceneModel model, LinkPlaces places, Matrix4fc toShadow) {
    ShadowCaster caster = new ShadowCaster(model.arm().id(), model.positionRad(), model.world());
    if (inShadow.equals(Optional.of(caster))) {
      return;
    }
    inShadow = Optional.of(caster);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    shadow.begin();
    depth.use().set("toClip", toShadow);
    place(depth, places);
    bodies.arm().draw();
    depth.set("places", 0, new Matrix4f());
    bodies.world().draw();
    shadow.end();
  }

  /** Where nothing was drawn. */
  private void drawSky(Theme theme) {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    setSky(sky.use(), theme);
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
  }

  private static void setSky(ShaderProgram program, Theme theme) {
    program.set("skyTop", Paints.screen(theme.topRgb()));
    program.set("skyBottom", Paints.screen(theme.bottomRgb()));
  }

  private void useSolid(
      SceneModel model, Camera camera, Matrix4fc toClip, Matrix4fc toMap, Ground ground) {
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);
    boolean light = model.theme() == Theme.LIGHT;
    solid.use().set("toClip", toClip);
    solid.set("toLight", toMap);
    solid.setAll("finishes", Paints.finishes(model.theme()));
    solid.set("eye", vector(camera.eyeM()));
    solid.set("toSun", TO_SUN);
    solid.set("sunlight", light ? 0.80f : 0.78f);
    solid.set(
        "sky", light ? new Vector3f(0.40f, 0.43f, 0.48f) : new Vector3f(0.22f, 0.245f, 0.28f));
    solid.set(
        "ground",
        light ? new Vector3f(0.20f, 0.197f, 0.193f) : new Vector3f(0.06f, 0.062f, 0.068f));
    solid.set("tint", NO_TINT, 0);
    solid.set("opacity", 1);
    solid.set("shadowOffset", SHADOW_OFFSET_SHARE * (float) model.arm().reachM());
    solid.set("floorHeight", (float) ground.heightM());
    solid.setTexture("shadowMap", 0);
  }

  private void drawBodies(SceneModel model, LinkPlaces places) {
    place(solid, places);
    bodies.arm().draw();
    solid.set("places", 0, new Matrix4f());
    bodies.world().draw();
    float length = (float) (0.05 + 0.1 * model.arm().reachM());
    Matrix4f tcp = LinkPlaces.matrix(model.tcpInBase());
    drawFrame(new Matrix4f(), length);
    drawFrame(tcp, length);
    for (Pose frame : model.framesInBase()) {
      drawFrame(LinkPlaces.matrix(frame), length);
    }
    drawRod(new Matrix4f(places.of(Link.WRIST_3)), tcp);
  }

  private void drawFrame(Matrix4f frame, float lengthM) {
    solid.set("places", 0, frame.scale(lengthM, new Matrix4f()));
    bodies.frame().draw();
  }

  /** From the flange to the tool centre point, so that nobody wonders what holds it. */
  private void drawRod(Matrix4f flange, Matrix4f tcp) {
    Vector3f from = flange.getTranslation(new Vector3f());
    Vector3f way = tcp.getTranslation(new Vector3f()).sub(from);
    float length = way.length();
    if (length > 1e-4f) {
      Matrix4f place = new Matrix4f().translation(from);
      place.rotateTowards(way.div(length), leastAlong(way));
      solid.set("places", 0, place.scale(1, 1, length));
      bodies.rod().draw();
    }
  }

  private static Vector3f leastAlong(Vector3f direction) {
    return Math.abs(direction.z) < 0.7f ? new Vector3f(0, 0, 1) : new Vector3f(1, 0, 0);
  }

  private void usePlane(SceneModel model, Matrix4fc toClip, Matrix4fc toMap) {
    Theme theme = model.theme();
    glDisable(GL_CULL_FACE);
    plane.use().set("toClip", toClip);
    plane.set("toLight", toMap);
    plane.setTexture("shadowMap", 0);
    plane.set("axisX", Paints.screen(theme.rgb(Finish.AXIS_X)));
    plane.set("axisY", Paints.screen(theme.rgb(Finish.AXIS_Y)));
    plane.set("shade", theme == Theme.LIGHT ? 0.36f : 0.55f);
    setSky(plane, theme);
  }

  /**
   * @param pictureHeight to fade into the sky, or 0 to let everything be seen through
   */
  private void drawFloor(SceneModel model, Ground ground, int pictureHeight) {
    Theme theme = model.theme();
    float reach = (float) model.arm().reachM();
    int rgb = ground.touched() ? theme.rgb(Finish.TOUCHED) : theme.floorRgb();
    plane.use().set("axes", 1);
    plane.set("halfSize", 4.5f * reach);
    plane.set("reach", 1.25f * reach);
    plane.set("pictureHeight", pictureHeight);
    if (pictureHeight == 0) {
      blend();
    }
    drawPlane(
        new Matrix4f().translation(0, 0, (float) ground.heightM()),
        Paints.screen(theme.floorRgb()).lerp(Paints.screen(rgb), 0.3f),
        theme.gridRgb(),
        pictureHeight > 0 ? 1 : 0.15f);
  }

  private void drawPlanes(SceneModel model, Ground ground) {
    float reach = (float) model.arm().reachM();
    blend();
    glDepthMask(false);
    plane.use().set("axes", 0);
    plane.set("halfSize", 1.6f * reach);
    plane.set("reach", 0.8f * reach);
    plane.set("pictureHeight", 0);
    for (Ground.Patch patch : ground.planes()) {
      int rgb = model.theme().rgb(patch.touched() ? Finish.TOUCHED : Finish.OBJECT);
      drawPlane(patch.frame(), Paints.screen(rgb), rgb, 0.3f);
    }
    glDepthMask(true);
  }

  private static void blend() {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }

  private void drawPlane(Matrix4fc place, Vector3f fill, int lineRgb, float fillOpacity) {
    plane.set("place", place);
    plane.set("fill", fill);
    plane.set("line", Paints.screen(lineRgb));
    plane.set("fillOpacity", fillOpacity);
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }

  private void drawTrace(Matrix4fc toClip, int width, int height) {
    blend();
    glDisable(GL_CULL_FACE);
    glDepthMask(false);
    trace.use().set("toClip", toClip);
    trace.set("halfPixels", width / 2f, height / 2f);
    trace.set("width", Math.max(1.5f, TRACE_PX_AT_800 * height / 800f));
    trace.set("opacity", 1);
    strip.draw();
    glDepthFunc(GL_GREATER);
    trace.set("opacity", HIDDEN_TRACE_OPACITY);
    strip.draw();
    glDepthFunc(GL_LESS);
    glDepthMask(true);
  }

  /** Its depths first, so that no far side shines through the near one. */
  private void drawGhost(SceneModel model) {
    if (model.ghostRad().isEmpty()) {
      return;
    }
    place(solid, new LinkPlaces(model.kinematics(), model.arm().dh(), model.ghostRad().get()));
    solid.set("tint", Paints.linear(GHOST_RGB), 0.7f);
    solid.set("opacity", 0.38f);
    // Where both arms are in one place, the real one is in front.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 16);
    glColorMask(false, false, false, false);
    bodies.arm().draw();
    glColorMask(true, true, true, true);
    blend();
    glDepthFunc(GL_LEQUAL);
    bodies.arm().draw();
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
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
    strip.close();
    bodies.close();
    shadow.close();
    glDeleteVertexArrays(emptyArray);
    solid.close();
    depth.close();
    plane.close();
    sky.close();
    trace.close();
  }
}
