package org.pendant.models.mesh;

/**
 * Mesh exception: a file is no mesh of a solid; the message says what is wrong, without the file.
 */
public final class MeshException extends Exception {
  private static final long serialVersionUID = 1L;

  MeshException(String message) {
    super(message);
  }
}
