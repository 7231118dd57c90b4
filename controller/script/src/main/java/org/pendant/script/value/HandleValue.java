package org.pendant.script.value;

import org.pendant.language.signature.Type;

/**
 * A handle to something outside the script (an RPC connection, a fieldbus reader), given out by a
 * factory function. Its methods are the factory's business.
 *
 * @param type what it is a handle to
 * @param id number that tells handles of one type and program apart
 * @param path what a script has said after the handle, without its first dot: {@code server} in
 *     {@code h.server.start()}; empty for the handle itself
 */
public record HandleValue(Type type, int id, String path) implements Value {
  private static final long HEADER_BYTES = 64;

  @Override
  public ValueKind kind() {
    return ValueKind.HANDLE;
  }

  @Override
  public long sizeBytes() {
    return HEADER_BYTES + path.length();
  }

  /** This handle followed by a dot and {@code name}. */
  public HandleValue member(String name) {
    return new HandleValue(type, id, path.isEmpty() ? name : path + "." + name);
  }
}
