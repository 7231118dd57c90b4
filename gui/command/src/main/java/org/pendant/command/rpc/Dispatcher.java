package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;

/**
 * Dispatcher: has each request carried out by its method, in the order of the lines. Whatever comes
 * in, what goes out is an answer of JSON-RPC.
 */
final class Dispatcher {
  /** Requests of a batch at most: answers are longer than what asks for nothing. */
  static final int MAX_BATCH = 1_000;

  private static final Object NO_ID = Optional.empty();
  private static final Json NO_PARAMS =
      new Json.Members(Map.of(), new FilePosition(RpcCodec.FILE, 1, 1));

  private final MethodTable methods;
  private final Consumer<Throwable> faults;

  /**
   * A dispatcher.
   *
   * @param faults is told of faults in Pendant
   */
  Dispatcher(MethodTable methods, Consumer<Throwable> faults) {
    this.methods = methods;
    this.faults = faults;
  }

  /** The answer to a line; empty for a notification and for a blank line. */
  Optional<String> answer(ByteBuffer line) {
    if (isBlank(line)) {
      return Optional.empty();
    }
    Optional<?> answer;
    try {
      answer =
          switch (RpcCodec.read(line)) {
            case Json.Elements batch -> batch(batch.values());
            case Json request -> single(request);
          };
    } catch (RpcFailure e) {
      answer = Optional.of(RpcCodec.error(NO_ID, e));
    }
    return answer.map(RpcCodec::text);
  }

  /** The answer to a line that could not be read. */
  static String refusal(RpcFailure failure) {
    return RpcCodec.text(RpcCodec.error(NO_ID, failure));
  }

  private static boolean isBlank(ByteBuffer line) {
    for (int i = line.position(); i < line.limit(); i++) {
      byte each = line.get(i);
      if (each != ' ' && each != '\t' && each != '\r') {
        return false;
      }
    }
    return true;
  }

  private Optional<List<Object>> batch(List<Json> requests) throws RpcFailure {
    if (requests.isEmpty()) {
      throw invalid(text("emptyBatch"));
    }
    if (requests.size() > MAX_BATCH) {
      throw invalid(text("longBatch", requests.size(), MAX_BATCH));
    }
    List<Object> answers = new ArrayList<>();
    for (Json each : requests) {
      single(each).ifPresent(answers::add);
    }
    return answers.isEmpty() ? Optional.empty() : Optional.of(answers);
  }

  private Optional<Map<String, Object>> single(Json request) {
    Object id = NO_ID;
    try {
      if (!(request instanceof Json.Members members)) {
        throw invalid(text("wrongRequest", request.described()));
      }
      Json.Member sent = members.byKey().get("id");
      if (sent != null) {
        id = RpcCodec.id(sent.value());
      }
      Object result = carryOut(members);
      return sent == null ? Optional.empty() : Optional.of(RpcCodec.result(id, result));
    } catch (RpcFailure e) {
      return isNotification(request, e) ? Optional.empty() : Optional.of(RpcCodec.error(id, e));
    }
  }

  /** What is no request at all is answered; a request without id is not. */
  private static boolean isNotification(Json request, RpcFailure failure) {
    return request instanceof Json.Members members
        && !members.byKey().containsKey("id")
        && failure.code() != RpcFailure.INVALID_REQUEST;
  }

  private Object carryOut(Json.Members request) throws RpcFailure {
    if (!(value(request, "jsonrpc") instanceof Json.Text version)
        || !version.value().equals("2.0")) {
      throw invalid(text("wrongVersion"));
    }
    if (!(value(request, "method") instanceof Json.Text name)) {
      throw invalid(text("wrongMethod"));
    }
    RpcMethod method = methods.of(name.value());
    RpcParams params = RpcParams.of(value(request, "params"));
    try {
      return method.call(params);
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError fault) {
      faults.accept(fault);
      throw new RpcFailure(RpcFailure.INTERNAL_ERROR, text("internalError", fault));
    }
  }

  private static Json value(Json.Members request, String key) {
    Json.Member member = request.byKey().get(key);
    return member == null ? NO_PARAMS : member.value();
  }

  private static RpcFailure invalid(String message) {
    return new RpcFailure(RpcFailure.INVALID_REQUEST, message);
  }
}
