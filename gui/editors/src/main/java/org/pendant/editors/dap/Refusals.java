package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.language.source.ByteText;
import org.pendant.script.value.ScriptError;

/** Refusals: what a client is told of a request that is not carried out. */
final class Refusals {
  /** What the client may show, by the protocol's number of the message. */
  private static final int MESSAGE = 1;

  private Refusals() {}

  /** A refusal for a reason that people read. */
  static ResponseErrorException of(String reason) {
    return new ResponseErrorException(error(ResponseErrorCode.RequestFailed, reason));
  }

  /** A refusal as what comes of a request. */
  static <T> CompletableFuture<T> answer(String reason) {
    return CompletableFuture.failedFuture(of(reason));
  }

  /** What people are told of a question that failed. */
  static String words(Throwable fault) {
    Throwable cause = fault;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return ByteText.decoded(String.valueOf(cause.getMessage()));
  }

  /** What a client is told of a request that failed. */
  static ResponseError told(
      Throwable fault, Consumer<Throwable> faults, UnaryOperator<String> shown) {
    Throwable cause = fault;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return switch (cause) {
      case ResponseErrorException refused ->
          error(
              refused.getResponseError().getCode(),
              shown.apply(refused.getResponseError().getMessage()));
      case CancellationException _ ->
          error(ResponseErrorCode.RequestCancelled, shown.apply(text("cancelled")));
      case IllegalArgumentException _, ScriptError _, TargetRefusal _ ->
          error(
              ResponseErrorCode.RequestFailed,
              shown.apply(ByteText.decoded(String.valueOf(cause.getMessage()))));
      // What the adapter says that it cannot do, and a client asks for all the same.
      case UnsupportedOperationException _ ->
          error(ResponseErrorCode.MethodNotFound, shown.apply(text("notSupported")));
      default -> {
        faults.accept(cause);
        yield error(ResponseErrorCode.InternalError, shown.apply(text("internalError", cause)));
      }
    };
  }

  private static ResponseError error(ResponseErrorCode code, String text) {
    return error(code.getValue(), text);
  }

  private static ResponseError error(int code, String text) {
    Map<String, Object> message =
        Map.of("id", MESSAGE, "format", text.replace("{", "(").replace("}", ")"));
    return new ResponseError(code, text, Map.of("error", message));
  }
}
