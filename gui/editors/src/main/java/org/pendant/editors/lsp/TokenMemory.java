package org.pendant.editors.lsp;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/** Token memory: the colours that the client has of each open text, so that it is sent changes. */
final class TokenMemory {
  private final Map<String, Sent> sent = new ConcurrentHashMap<>();
  private final AtomicLong count = new AtomicLong();

  private record Sent(String id, List<Integer> numbers) {}

  /** Keeps what is sent for {@code uri}; its name for later. */
  String keep(String uri, List<Integer> numbers) {
    String id = Long.toString(count.incrementAndGet());
    sent.put(uri, new Sent(id, numbers));
    return id;
  }

  /** What was sent as {@code id}, if it was the last for {@code uri}. */
  Optional<List<Integer>> find(String uri, String id) {
    return Optional.ofNullable(sent.get(uri))
        .filter(each -> each.id().equals(id))
        .map(Sent::numbers);
  }

  void forget(String uri) {
    sent.remove(uri);
  }
}
