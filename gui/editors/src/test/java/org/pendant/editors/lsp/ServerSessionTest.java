package org.pendant.editors.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;

final class ServerSessionTest {
  @Test
  void whatLooksAtAllFilesDelaysNeitherAnswersNorWhatIsPushed() throws Exception {
    List<Throwable> faults = new CopyOnWriteArrayList<>();
    try (ServerSession session = new ServerSession(faults::add)) {
      CompletableFuture<String> files = new CompletableFuture<>();
      CompletableFuture<String> slow = session.answerOfWorkspace(cancelled -> files.join());
      CompletableFuture<String> pushed = new CompletableFuture<>();
      session.later(() -> pushed.complete("diagnostics"), 0);
      assertEquals("diagnostics", pushed.get());
      assertEquals("completion", session.answer(cancelled -> "completion").get());
      assertFalse(slow.isDone());
      files.complete("symbols");
      assertEquals("symbols", slow.get());
    }
    assertEquals(List.of(), faults);
  }
}
