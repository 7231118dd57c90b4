package org.pendant.language.signature;

/** Type: what a parameter accepts or a function returns, as far as it is known before running. */
public enum Type {
  /** Anything, or not known. */
  ANY("any"),
  /** No value. */
  NONE("none"),
  BOOL("bool"),
  INT("int"),
  /** An int or a float. */
  NUMBER("number"),
  STRING("string"),
  POSE("pose"),
  LIST("list"),
  /** A list of six numbers, one a joint. */
  JOINTS("list of 6 numbers"),
  /** A pose, or six joint positions. */
  POSE_OR_JOINTS("pose or list of 6 numbers"),
  MATRIX("matrix"),
  STRUCT("struct"),
  /** A connection to a server of remote procedures; only the server knows its methods. */
  RPC_HANDLE("rpc handle"),
  /** A way to data that are exchanged by EtherNet/IP. */
  EIP_HANDLE("eip handle");

  private final String text;

  Type(String text) {
    this.text = text;
  }

  /** The name for messages and documentation. */
  public String text() {
    return text;
  }
}
