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
  JOINTS("joints"),
  /** A pose, or six joint positions. */
  POSE_OR_JOINTS("poseOrJoints"),
  MATRIX("matrix"),
  STRUCT("struct"),
  /** A connection to a server of remote procedures; only the server knows its methods. */
  RPC_HANDLE("rpcHandle"),
  /** A way to data that are exchanged by EtherNet/IP. */
  EIP_HANDLE("eipHandle");

  private final String key;

  Type(String key) {
    this.key = key;
  }

  /** The name for messages and documentation. */
  public String text() {
    return SignatureTexts.text(key);
  }
}
