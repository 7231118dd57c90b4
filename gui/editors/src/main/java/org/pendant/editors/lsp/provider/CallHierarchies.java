package org.pendant.editors.lsp.provider;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.lsp4j.CallHierarchyIncomingCall;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCall;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SymbolKind;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.CallSite;
import org.pendant.language.service.OutlineItem;
import org.pendant.language.service.Symbol;

/** Call hierarchies: who calls a function or starts a thread, and what that calls itself. */
public final class CallHierarchies {
  private CallHierarchies() {}

  /** The function or thread of this text that is named at {@code position}. */
  public static List<CallHierarchyItem> at(Document document, Position position) {
    return document
        .analysis()
        .occurrence(document.offset(position))
        .map(each -> each.symbol())
        .flatMap(CallHierarchies::definedAt)
        .flatMap(at -> definition(document, at))
        .map(item -> item(document, item))
        .stream()
        .toList();
  }

  /** The calls of {@code item}, by the definitions that they stand in. */
  public static List<CallHierarchyIncomingCall> incoming(
      Document document, CallHierarchyItem item) {
    int at = document.offset(item.getSelectionRange().getStart());
    Map<OutlineItem, List<Range>> callers = new LinkedHashMap<>();
    for (CallSite call : document.analysis().calls()) {
      if (call.caller().isPresent() && definedAt(call.callee()).equals(Optional.of(at))) {
        definition(document, call.caller().getAsInt())
            .ifPresent(caller -> add(callers, caller, document.range(call.nameRange())));
      }
    }
    return callers.entrySet().stream()
        .map(each -> new CallHierarchyIncomingCall(item(document, each.getKey()), each.getValue()))
        .toList();
  }

  /** What {@code item} calls of this text. */
  public static List<CallHierarchyOutgoingCall> outgoing(
      Document document, CallHierarchyItem item) {
    int at = document.offset(item.getSelectionRange().getStart());
    Map<OutlineItem, List<Range>> called = new LinkedHashMap<>();
    for (CallSite call : document.analysis().calls()) {
      if (call.caller().isPresent() && call.caller().getAsInt() == at) {
        definedAt(call.callee())
            .flatMap(callee -> definition(document, callee))
            .ifPresent(callee -> add(called, callee, document.range(call.nameRange())));
      }
    }
    return called.entrySet().stream()
        .map(each -> new CallHierarchyOutgoingCall(item(document, each.getKey()), each.getValue()))
        .toList();
  }

  private static void add(Map<OutlineItem, List<Range>> all, OutlineItem item, Range range) {
    all.computeIfAbsent(item, key -> new ArrayList<>()).add(range);
  }

  private static Optional<Integer> definedAt(Symbol symbol) {
    return symbol instanceof Symbol.Function function
        ? Optional.of(function.definedAt())
        : Optional.empty();
  }

  private static Optional<OutlineItem> definition(Document document, int nameAt) {
    return find(document.analysis().outline(), nameAt);
  }

  private static Optional<OutlineItem> find(List<OutlineItem> items, int nameAt) {
    for (OutlineItem item : items) {
      if (item.kind() != OutlineItem.Kind.GLOBAL && item.nameRange().start() == nameAt) {
        return Optional.of(item);
      }
      Optional<OutlineItem> inside = find(item.children(), nameAt);
      if (inside.isPresent()) {
        return inside;
      }
    }
    return Optional.empty();
  }

  private static CallHierarchyItem item(Document document, OutlineItem item) {
    CallHierarchyItem told =
        new CallHierarchyItem(
            item.name(),
            item.kind() == OutlineItem.Kind.THREAD ? SymbolKind.Event : SymbolKind.Function,
            document.uri(),
            document.range(item.range()),
            document.range(item.nameRange()));
    told.setDetail(item.detail());
    return told;
  }
}
