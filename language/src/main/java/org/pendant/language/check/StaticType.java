package org.pendant.language.check;

import org.pendant.language.signature.Type;

/**
 * Static type: what a value certainly is, as far as the text alone tells; {@link #ANY} where it
 * does not.
 */
enum StaticType {
  ANY("aValue"),
  BOOL("aBool"),
  /** An int, a float or a thread handle. */
  NUMBER("aNumber"),
  STRING("aString"),
  POSE("aPose"),
  LIST("aList"),
  MATRIX("aMatrix"),
  STRUCT("aStruct");

  private final String key;

  StaticType(String key) {
    this.key = key;
  }

  /** With its article, for messages. */
  String text() {
    return CheckTexts.text(key);
  }

  boolean certain() {
    return this != ANY;
  }

  /** Whether it has a truth: bools do, numbers unless they are zero, strings unless empty. */
  boolean condition() {
    return this == ANY || this == BOOL || this == NUMBER || this == STRING;
  }

  /** What a variable may hold that is assigned this kind and {@code other} at different places. */
  StaticType or(StaticType other) {
    return this == other ? this : ANY;
  }

  /**
   * Whether a variable that holds this kind certainly cannot take {@code other}. Structs convert to
   * lists (manual 4.1.1), so that pair is never certain.
   */
  boolean refuses(StaticType other) {
    boolean convertible = (this == STRUCT && other == LIST) || (this == LIST && other == STRUCT);
    return certain() && other.certain() && this != other && !convertible;
  }

  static StaticType of(Type type) {
    return switch (type) {
      case BOOL -> BOOL;
      case INT, NUMBER -> NUMBER;
      case STRING -> STRING;
      case POSE -> POSE;
      case LIST, JOINTS -> LIST;
      case MATRIX -> MATRIX;
      case STRUCT -> STRUCT;
      case ANY, NONE, POSE_OR_JOINTS, RPC_HANDLE, EIP_HANDLE -> ANY;
    };
  }

  /** The type of receiver whose methods the catalogue lists for this kind, else ANY. */
  Type receiver() {
    return switch (this) {
      case LIST -> Type.LIST;
      case MATRIX -> Type.MATRIX;
      case STRUCT -> Type.STRUCT;
      case ANY, BOOL, NUMBER, STRING, POSE -> Type.ANY;
    };
  }

  /** Whether a parameter of {@code type} may take this kind; true unless it certainly may not. */
  boolean fits(Type type) {
    return switch (this) {
      case ANY -> true;
      case STRING ->
          switch (type) {
            case ANY, NONE, STRING -> true;
            case BOOL,
                INT,
                NUMBER,
                POSE,
                LIST,
                JOINTS,
                POSE_OR_JOINTS,
                MATRIX,
                STRUCT,
                RPC_HANDLE,
                EIP_HANDLE ->
                false;
          };
      case BOOL, NUMBER ->
          switch (type) {
            case ANY, NONE, BOOL, INT, NUMBER -> true;
            case STRING,
                POSE,
                LIST,
                JOINTS,
                POSE_OR_JOINTS,
                MATRIX,
                STRUCT,
                RPC_HANDLE,
                EIP_HANDLE ->
                false;
          };
      case POSE, LIST ->
          switch (type) {
            case ANY, NONE, POSE, LIST, JOINTS, POSE_OR_JOINTS -> true;
            case MATRIX -> this == LIST;
            case STRUCT -> this == LIST;
            case BOOL, INT, NUMBER, STRING, RPC_HANDLE, EIP_HANDLE -> false;
          };
      case MATRIX ->
          switch (type) {
            case ANY, NONE, MATRIX, LIST -> true;
            case BOOL,
                INT,
                NUMBER,
                STRING,
                POSE,
                JOINTS,
                POSE_OR_JOINTS,
                STRUCT,
                RPC_HANDLE,
                EIP_HANDLE ->
                false;
          };
      case STRUCT ->
          switch (type) {
            case ANY, NONE, STRUCT, LIST, JOINTS -> true;
            case BOOL, INT, NUMBER, STRING, POSE, POSE_OR_JOINTS, MATRIX, RPC_HANDLE, EIP_HANDLE ->
                false;
          };
    };
  }
}
