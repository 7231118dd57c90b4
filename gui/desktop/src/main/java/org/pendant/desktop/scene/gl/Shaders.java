package org.pendant.desktop.scene.gl;

import java.util.EnumMap;
import java.util.Map;

/** Shaders: every program of the graphics; those that look for shadows in all their forms. */
final class Shaders implements AutoCloseable {
  private final Map<Shadows, ShaderProgram> solids = new EnumMap<>(Shadows.class);
  private final Map<Shadows, ShaderProgram> planes = new EnumMap<>(Shadows.class);
  private final ShaderProgram depth = new ShaderProgram("depth");
  private final ShaderProgram sky = new ShaderProgram("sky");
  private final ShaderProgram line = new ShaderProgram("line");

  /** Bodies, lit. */
  ShaderProgram solid(Shadows shadows) {
    return solids.computeIfAbsent(shadows, each -> new ShaderProgram("solid", each));
  }

  /** Planes with a grid. */
  ShaderProgram plane(Shadows shadows) {
    return planes.computeIfAbsent(shadows, each -> new ShaderProgram("plane", each));
  }

  /** Bodies as the light sees them. */
  ShaderProgram depth() {
    return depth;
  }

  /** What is behind everything. */
  ShaderProgram sky() {
    return sky;
  }

  /** Lines of an even width. */
  ShaderProgram line() {
    return line;
  }

  @Override
  public void close() {
    solids.values().forEach(ShaderProgram::close);
    planes.values().forEach(ShaderProgram::close);
    depth.close();
    sky.close();
    line.close();
  }
}
