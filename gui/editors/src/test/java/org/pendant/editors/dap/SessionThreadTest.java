package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.jsonrpc.Endpoint;
import org.eclipse.lsp4j.jsonrpc.MessageConsumer;
import org.eclipse.lsp4j.jsonrpc.RemoteEndpoint;
import org.eclipse.lsp4j.jsonrpc.messages.RequestMessage;
import org.junit.jupiter.api.Test;

final class SessionThreadTest {
  /** A cancellation names what it is about by this number. */
  @Test
  void workKnowsTheNumberOfItsRequest() throws Exception {
    List<OptionalInt> asked = new ArrayList<>();
    try (SessionThread turns = new SessionThread()) {
      Endpoint adapter =
          new Endpoint() {
            @Override
            public CompletableFuture<?> request(String method, Object parameter) {
              return turns.request(
                  () -> {
                    asked.add(turns.asked());
                    return CompletableFuture.completedFuture(method);
                  });
            }

            @Override
            public void notify(String method, Object parameter) {}
          };
      MessageConsumer reader = turns.gated(new RemoteEndpoint(message -> {}, adapter));
      for (String id : List.of("7", "8", "strange")) {
        RequestMessage request = new RequestMessage();
        request.setId(id);
        request.setMethod("stepBack");
        reader.consume(request);
      }
      CompletableFuture<Boolean> turn = new CompletableFuture<>();
      turns.execute(() -> turn.complete(true));
      turn.get();
    }
    assertEquals(List.of(OptionalInt.of(7), OptionalInt.of(8), OptionalInt.empty()), asked);
  }
}
