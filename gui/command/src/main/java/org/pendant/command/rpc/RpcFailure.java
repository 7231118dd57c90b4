package org.pendant.command.rpc;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.command.Refusal;
import org.pendant.models.json.JsonException;

/**
 * RPC failure: why a request is not answered by a result. Carries no stack trace, it is no fault of
 * the program.
 */
public final class RpcFailure extends Exception {
  private static final long serialVersionUID = 1L;

  /** The line is no JSON. */
  public static final int PARSE_ERROR = -32700;

  /** The JSON is no request. */
  public static final int INVALID_REQUEST = -32600;

  /** There is no such method. */
  public static final int METHOD_NOT_FOUND = -32601;

  /** A parameter is missing, unknown or not what it must be. */
  public static final int INVALID_PARAMS = -32602;

  /** A fault in Pendant. */
  public static final int INTERNAL_ERROR = -32603;

  /** The controller has refused it, and nothing has changed. */
  public static final int REFUSED = -32000;

  /** There is no robot with this handle. */
  public static final int NO_SUCH_ROBOT = -32001;

  /** There is no program to start, or it has failed. */
  public static final int PROGRAM = -32002;

  /** A file cannot be read, or is not what it must be. */
  public static final int UNREADABLE = -32003;

  /** It takes longer on the wall than it may; robot time has passed until then. */
  public static final int WALL_TIME = -32004;

  /** The answer would be larger than it may be. */
  public static final int TOO_MUCH = -32005;

  private static final Pattern PLACE = Pattern.compile(RpcCodec.FILE + ":(\\d+):(\\d+): (.*)");

  private final int code;
  private final transient Map<String, Object> data;

  /** A failure of which there is nothing more to say. */
  public RpcFailure(int code, String message) {
    this(code, message, Map.of());
  }

  /**
   * A failure.
   *
   * @param code one of the constants
   * @param data what programs can use: texts and numbers by name
   */
  public RpcFailure(int code, String message, Map<String, Object> data) {
    super(message, null, false, false);
    this.code = code;
    this.data = Collections.unmodifiableMap(new LinkedHashMap<>(data));
  }

  /** What is wrong in the text of a request, with the column as data. */
  static RpcFailure of(int code, JsonException wrong) {
    Matcher place = PLACE.matcher(wrong.getMessage());
    return place.matches()
        ? new RpcFailure(code, place.group(3), Map.of("column", Integer.parseInt(place.group(2))))
        : new RpcFailure(code, wrong.getMessage());
  }

  /** What the controller has refused. */
  static RpcFailure of(Refusal refusal) {
    return new RpcFailure(
        REFUSED,
        refusal.text(),
        Map.of("code", refusal.code().name().toLowerCase(Locale.ROOT).replace('_', '-')));
  }

  /** A parameter that is not what it must be. */
  static RpcFailure params(String message) {
    return new RpcFailure(INVALID_PARAMS, message);
  }

  int code() {
    return code;
  }

  Map<String, Object> data() {
    return data;
  }
}
