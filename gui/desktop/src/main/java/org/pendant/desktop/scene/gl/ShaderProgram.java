package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4fc;
import org.joml.Vector3fc;

/**
 * Shader program: a vertex shader and a fragment shader from the resources, and their uniforms by
 * name.
 */
final class ShaderProgram implements AutoCloseable {
  private static final String INCLUDE = "#include ";

  private final int id;
  private final Map<String, Integer> locations = new HashMap<>();
  private final float[] sixteen = new float[16];

  /**
   * @param name of the two resources, which end in {@code .vert} and {@code .frag}
   */
  ShaderProgram(String name) {
    this(name, Shadows.NONE);
  }

  /**
   * @param name of the two resources, which end in {@code .vert} and {@code .frag}
   * @param shadows how they look for shadows
   */
  ShaderProgram(String name, Shadows shadows) {
    int vertex = compile(GL_VERTEX_SHADER, name + ".vert", shadows);
    int fragment = compile(GL_FRAGMENT_SHADER, name + ".frag", shadows);
    id = glCreateProgram();
    glAttachShader(id, vertex);
    glAttachShader(id, fragment);
    glLinkProgram(id);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    if (glGetProgrami(id, GL_LINK_STATUS) == 0) {
      throw new IllegalStateException(name + " does not link: " + glGetProgramInfoLog(id));
    }
  }

  private static int compile(int kind, String file, Shadows shadows) {
    int shader = glCreateShader(kind);
    glShaderSource(shader, defining(shadows.define(), source(file)));
    glCompileShader(shader);
    if (glGetShaderi(shader, GL_COMPILE_STATUS) == 0) {
      throw new IllegalStateException(file + " does not compile: " + glGetShaderInfoLog(shader));
    }
    return shader;
  }

  /** After the line with the version, which must come first. */
  private static String defining(String symbol, String source) {
    int version = source.indexOf('\n') + 1;
    return source.substring(0, version) + "#define " + symbol + "\n" + source.substring(version);
  }

  private static String source(String file) {
    StringBuilder source = new StringBuilder();
    for (String line : lines(file)) {
      source
          .append(
              line.startsWith(INCLUDE) ? source(line.substring(INCLUDE.length()).strip()) : line)
          .append('\n');
    }
    return source.toString();
  }

  private static List<String> lines(String file) {
    try (InputStream in = ShaderProgram.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException("the resource " + file + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    } catch (IOException e) {
      throw new UncheckedIOException("the resource " + file + " cannot be read", e);
    }
  }

  /** Uniforms and drawing that follow are this program's. */
  ShaderProgram use() {
    glUseProgram(id);
    return this;
  }

  void set(String name, float value) {
    glUniform1f(location(name), value);
  }

  void set(String name, float x, float y) {
    glUniform2f(location(name), x, y);
  }

  void set(String name, Vector3fc v) {
    glUniform3f(location(name), v.x(), v.y(), v.z());
  }

  void set(String name, Vector3fc v, float w) {
    glUniform4f(location(name), v.x(), v.y(), v.z(), w);
  }

  void set(String name, float[] four) {
    glUniform4f(location(name), four[0], four[1], four[2], four[3]);
  }

  void set(String name, boolean value) {
    glUniform1i(location(name), value ? 1 : 0);
  }

  void set(String name, Matrix4fc matrix) {
    glUniformMatrix4fv(location(name), false, matrix.get(sixteen));
  }

  /** Sets element {@code i} of an array of matrices. */
  void set(String name, int i, Matrix4fc matrix) {
    set(name + "[" + i + "]", matrix);
  }

  /** Sets an array of four numbers each. */
  void setAll(String name, float[] fours) {
    glUniform4fv(location(name), fours);
  }

  /** Sets a number whose bits count. */
  void setBits(String name, int bits) {
    glUniform1i(location(name), bits);
  }

  void setTexture(String name, int unit) {
    glUniform1i(location(name), unit);
  }

  private int location(String name) {
    return locations.computeIfAbsent(name, key -> glGetUniformLocation(id, key));
  }

  @Override
  public void close() {
    glDeleteProgram(id);
  }
}
