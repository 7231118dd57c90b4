package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.util.List;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.pendant.desktop.scene.Ground;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.Sheets;
import org.pendant.desktop.scene.mesh.Finish;

/**
 * Surroundings: draws what has no end: the floor with its grid, planes of the scene, and the sky.
 */
final class Surroundings implements AutoCloseable {
  /** The floor is there up to this share of the arm's reach, and then fades. */
  static final float FLOOR_REACH = 1.25f;

  private static final float FLOOR_END = 4.5f;
  private static final float PLANE_REACH = 0.8f;
  private static final float PLANE_END = 1.6f;

  /** The corners of a square are farther from its middle than its edges. */
  private static final float BEYOND_CORNERS = 2;

  private static final int CELLS_AROUND = 8;
  private static final int CORNERS = 4;

  private final Shaders shaders;

  /** The core profile draws nothing without one, also where there is no buffer. */
  private final int emptyArray = glGenVertexArrays();

  Surroundings(Shaders shaders) {
    this.shaders = shaders;
  }

  /** Where nothing was drawn. */
  void drawSky(SceneTheme theme) {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    setSky(shaders.sky().use(), theme);
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
  }

  private static void setSky(ShaderProgram program, SceneTheme theme) {
    program.set("skyTop", Paints.screen(theme.topRgb()));
    program.set("skyBottom", Paints.screen(theme.bottomRgb()));
  }

  /**
   * The floor: only its part under the bodies looks for their shadow.
   *
   * @param pictureHeight to fade into the sky, or 0 to let everything be seen through
   * @param shadow the part, from x, y to x, y
   */
  void drawFloor(
      SceneModel model,
      Ground ground,
      Matrix4fc toClip,
      Matrix4fc toMap,
      int pictureHeight,
      Shadows shadows,
      float[] shadow) {
    if (pictureHeight == 0) {
      blend();
    } else {
      glDisable(GL_BLEND);
    }
    glDisable(GL_CULL_FACE);
    glBindVertexArray(emptyArray);
    useFloor(shaders.plane(Shadows.NONE), model, ground, toClip, toMap, pictureHeight, shadow)
        .set("around", true);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, CORNERS, CELLS_AROUND);
    useFloor(shaders.plane(shadows), model, ground, toClip, toMap, pictureHeight, shadow)
        .set("around", false);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, CORNERS);
  }

  private static ShaderProgram useFloor(
      ShaderProgram plane,
      SceneModel model,
      Ground ground,
      Matrix4fc toClip,
      Matrix4fc toMap,
      int pictureHeight,
      float[] shadow) {
    SceneTheme theme = model.theme();
    float reach = (float) model.arm().reachM();
    int rgb = ground.touched() ? theme.rgb(Finish.TOUCHED) : theme.floorRgb();
    use(plane, model, toClip, toMap);
    plane.set("axes", 1);
    plane.set("halfSize", FLOOR_END * reach);
    plane.set("reach", FLOOR_REACH * reach);
    plane.set("pictureHeight", pictureHeight);
    plane.set("middle", shadow);
    plane.set("place", new Matrix4f().translation(0, 0, (float) ground.heightM()));
    plane.set("fill", Paints.screen(theme.floorRgb()).lerp(Paints.screen(rgb), 0.3f));
    plane.set("line", Paints.screen(theme.gridRgb()));
    plane.set("lineOpacity", 1);
    plane.set("fillOpacity", pictureHeight > 0 ? 1 : 0.15f);
    return plane;
  }

  /** What is flat and can be seen through, in this order. */
  void drawSheets(
      List<Sheets.Sheet> sheets,
      SceneModel model,
      Matrix4fc toClip,
      Matrix4fc toMap,
      Shadows shadows) {
    if (sheets.isEmpty()) {
      return;
    }
    blend();
    glDisable(GL_CULL_FACE);
    glDepthMask(false);
    // One that lies on the floor is in front of it.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -16);
    glBindVertexArray(emptyArray);
    for (Sheets.Sheet sheet : sheets) {
      boolean square = sheet.halfSizeM() > 0;
      ShaderProgram plane = shaders.plane(square ? Shadows.NONE : shadows);
      use(plane, model, toClip, toMap);
      plane.set("axes", 0);
      plane.set("pictureHeight", 0);
      plane.set("around", false);
      setSize(plane, sheet, (float) model.arm().reachM());
      if (square) {
        plane.set("shade", 0);
      }
      Vector3f paint = Paints.screen(sheet.rgb());
      plane.set("fillOpacity", sheet.opacity());
      plane.set("place", sheet.frame());
      plane.set("fill", paint);
      plane.set("line", paint);
      plane.set("lineOpacity", square ? 0.4f : 1);
      glDrawArrays(GL_TRIANGLE_STRIP, 0, CORNERS);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(true);
  }

  /** A square ends at its edges, other planes fade out before. */
  private static void setSize(ShaderProgram plane, Sheets.Sheet sheet, float reach) {
    float half = sheet.halfSizeM() > 0 ? (float) sheet.halfSizeM() : PLANE_END * reach;
    float fades = sheet.halfSizeM() > 0 ? BEYOND_CORNERS * half : PLANE_REACH * reach;
    plane.set("middle", new float[] {-half, -half, half, half});
    plane.set("reach", fades);
    plane.set("halfSize", sheet.halfSizeM() > 0 ? 2 * fades : half);
  }

  private static void use(
      ShaderProgram plane, SceneModel model, Matrix4fc toClip, Matrix4fc toMap) {
    SceneTheme theme = model.theme();
    plane.use().set("toClip", toClip);
    plane.set("toLight", toMap);
    plane.setTexture("shadowMap", 0);
    plane.set("fineStep", (float) model.grid().fineM());
    plane.set("strongStep", (float) model.grid().strongM());
    plane.set("axisX", Paints.screen(theme.rgb(Finish.AXIS_X)));
    plane.set("axisY", Paints.screen(theme.rgb(Finish.AXIS_Y)));
    plane.set("shade", theme == SceneTheme.LIGHT ? 0.36f : 0.55f);
    setSky(plane, theme);
  }

  /** What is drawn next lets things shine through, by its opacity. */
  static void blend() {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }

  @Override
  public void close() {
    glDeleteVertexArrays(emptyArray);
  }
}
