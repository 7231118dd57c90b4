package org.pendant.controller.value;

/**
 * A handle to something outside the script (an RPC connection, a fieldbus reader), given out by a
 * factory function. Its methods are the factory's business.
 *
 * @param type what it is a handle to, for messages
 * @param id number that tells handles of one program apart
 */
public record HandleValue(String type, int id) implements Value {
  @Override
  public Kind kind() {
    return Kind.HANDLE;
  }
}
