package org.pendant.editors.lsp.provider;

import static org.pendant.editors.lsp.provider.AnswerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.QuickFix;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.SourceRange;

/** Code actions: what puts a diagnostic right, and all that can be put right at once. */
public final class CodeActions {
  /** Puts right what has one way only to be put right. */
  public static final String FIX_ALL = CodeActionKind.SourceFixAll + ".pendant";

  private CodeActions() {}

  /** Those for the diagnostics in the range of {@code asked}, of the kinds that it asks for. */
  public static List<CodeAction> of(
      Document document, CodeActionParams asked, ClientFeatures client) {
    List<CodeAction> actions = new ArrayList<>();
    List<String> kinds = asked.getContext().getOnly();
    if (wants(kinds, CodeActionKind.QuickFix)) {
      SourceRange range = document.positions().range(asked.getRange());
      document.analysis().diagnostics().stream()
          .filter(each -> overlaps(each.range(), range))
          .limit(DiagnosticAnswers.MAX_DIAGNOSTICS)
          .forEach(each -> actions.addAll(fixes(document, each, client)));
    }
    if (kinds != null && wants(kinds, FIX_ALL)) {
      fixAll(document, client).ifPresent(actions::add);
    }
    return List.copyOf(actions);
  }

  private static boolean wants(List<String> kinds, String kind) {
    return kinds == null
        || kinds.stream()
            .anyMatch(each -> each.isEmpty() || kind.equals(each) || kind.startsWith(each + "."));
  }

  private static boolean overlaps(SourceRange range, SourceRange asked) {
    return range.start() <= asked.end() && asked.start() <= range.end();
  }

  private static List<CodeAction> fixes(
      Document document, Diagnostic diagnostic, ClientFeatures client) {
    List<QuickFix> fixes = document.analysis().fixes(diagnostic);
    List<CodeAction> actions = new ArrayList<>();
    for (QuickFix fix : fixes) {
      CodeAction action =
          action(
              document,
              client.shown(ByteText.decoded(fix.title())),
              CodeActionKind.QuickFix,
              fix.edits());
      action.setDiagnostics(List.of(DiagnosticAnswers.diagnostic(document, diagnostic, client)));
      action.setIsPreferred(fixes.size() == 1);
      actions.add(action);
    }
    return actions;
  }

  /** What has one way only to be put right, unless another edit is in the way. */
  private static Optional<CodeAction> fixAll(Document document, ClientFeatures client) {
    List<org.pendant.language.service.TextEdit> edits = new ArrayList<>();
    for (Diagnostic diagnostic : document.analysis().diagnostics()) {
      List<QuickFix> fixes = document.analysis().fixes(diagnostic);
      if (fixes.size() == 1
          && fixes.getFirst().edits().stream().allMatch(each -> fits(each, edits))) {
        edits.addAll(fixes.getFirst().edits());
      }
    }
    return edits.isEmpty()
        ? Optional.empty()
        : Optional.of(action(document, client.shown(text("fixAll")), FIX_ALL, edits));
  }

  private static boolean fits(
      org.pendant.language.service.TextEdit edit,
      List<org.pendant.language.service.TextEdit> others) {
    return others.stream()
        .noneMatch(
            other ->
                edit.range().start() <= other.range().end()
                    && other.range().start() <= edit.range().end());
  }

  private static CodeAction action(
      Document document,
      String title,
      String kind,
      List<org.pendant.language.service.TextEdit> edits) {
    List<TextEdit> told = document.edits(edits);
    CodeAction action = new CodeAction(title);
    action.setKind(kind);
    action.setEdit(new WorkspaceEdit(Map.of(document.uri(), told)));
    return action;
  }
}
