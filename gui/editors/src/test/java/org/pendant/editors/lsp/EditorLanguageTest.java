package org.pendant.editors.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.concurrent.ExecutionException;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.CodeLensParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.junit.jupiter.api.Test;

/** A server says what people read in the language that their editor names. */
class EditorLanguageTest {
  private static final String URI = "file:///cell.script";

  private static final TextDocumentIdentifier TEXT = new TextDocumentIdentifier(URI);

  private static EditorClient speaking(String locale) throws Exception {
    EditorClient editor = EditorClient.start();
    InitializeParams asked = new InitializeParams();
    asked.setLocale(locale);
    editor.initialize(asked);
    return editor;
  }

  private static Diagnostic mistake(EditorClient editor) throws Exception {
    editor.open(URI, "movje([0,0,0,0,0,0])\n");
    return editor.nextDiagnostics().getDiagnostics().getFirst();
  }

  private static String hover(EditorClient editor, int line, int character) throws Exception {
    return editor
        .server()
        .getTextDocumentService()
        .hover(new HoverParams(TEXT, new Position(line, character)))
        .get()
        .getContents()
        .getRight()
        .getValue();
  }

  private static String refusal(EditorClient editor) {
    ExecutionException refused =
        assertThrows(
            ExecutionException.class,
            () ->
                editor
                    .server()
                    .getTextDocumentService()
                    .rename(new RenameParams(TEXT, new Position(0, 0), "if"))
                    .get());
    return assertInstanceOf(ResponseErrorException.class, refused.getCause()).getMessage();
  }

  @Test
  void mistakesAreToldInTheLanguageOfTheEditorAndTheirCodesStay() throws Exception {
    try (EditorClient editor = speaking("de-DE")) {
      Diagnostic mistake = mistake(editor);
      assertEquals("Funktion movje ist nicht definiert; ist movej gemeint?", mistake.getMessage());
      assertEquals("unknown-function", mistake.getCode().getLeft());
      assertEquals("pendant", mistake.getSource());
      var fix =
          editor
              .server()
              .getTextDocumentService()
              .codeAction(
                  new CodeActionParams(
                      TEXT,
                      new Range(new Position(0, 1), new Position(0, 1)),
                      new CodeActionContext(List.of(mistake))))
              .get()
              .getFirst()
              .getRight();
      assertEquals("Durch movej ersetzen", fix.getTitle());
      assertEquals(List.of(mistake), fix.getDiagnostics());
    }
  }

  @Test
  void aHoverSaysWhatWasFoundOutInThatLanguageAndLeavesWhatIsWritten() throws Exception {
    try (EditorClient editor = speaking("de")) {
      editor.open(
          URI,
          "# the program has ended\ndef open():\n  sleep(1)\nend\nopen()\nx = p[0,0,0,0,0,0]\n");
      assertEquals(
          String.join("\n", "def open()", "the program has ended", "Definiert in Zeile 2."),
          hover(editor, 4, 1));
      assertEquals(
          String.join(
              "\n",
              "sleep(t)",
              "Pauses this script thread; other threads and motions continue. Takes a frame at"
                  + " least.",
              "t: number in s",
              "Handbuch 16.54"),
          hover(editor, 2, 3));
      assertEquals(
          String.join("\n", "global x", "Enthält: Pose.", "Zuerst zugewiesen in Zeile 6."),
          hover(editor, 5, 0));
      assertEquals(
          String.join(
              "\n", "x 0 mm, y 0 mm, z 0 mm", "Drehvektor 0°, 0°, 0°", "Roll 0°, Nick 0°, Gier 0°"),
          hover(editor, 5, 4));
    }
  }

  @Test
  void lensesAreInThatLanguage() throws Exception {
    try (EditorClient editor = speaking("zh-cn")) {
      editor.open(URI, "sleep(1)\n");
      editor.nextDiagnostics();
      assertEquals(
          List.of("运行", "调试"),
          editor.server().getTextDocumentService().codeLens(new CodeLensParams(TEXT)).get().stream()
              .map(each -> each.getCommand().getTitle())
              .limit(2)
              .toList());
    }
  }

  @Test
  void twoEditorsOfOneProcessAreToldInTheirOwnLanguages() throws Exception {
    try (EditorClient german = speaking("de");
        EditorClient chinese = speaking("zh_CN");
        EditorClient other = speaking("fr")) {
      assertEquals(
          "Funktion movje ist nicht definiert; ist movej gemeint?", mistake(german).getMessage());
      assertEquals("函数 movje 未定义；是否指 movej？", mistake(chinese).getMessage());
      assertEquals(
          "function movje is not defined; did you mean movej?", mistake(other).getMessage());
      german.open(URI, "x = 1\n");
      assertEquals("if ist ein reserviertes Wort", refusal(german));
      assertEquals("没有定义 movje；应为有意义的名称", refusal(chinese));
      assertEquals("nothing defines movje; expected a name with a meaning", refusal(other));
    }
  }

  @Test
  void anEditorThatNamesNoLanguageIsToldInEnglish() throws Exception {
    try (EditorClient editor = speaking(null)) {
      assertEquals(
          "function movje is not defined; did you mean movej?", mistake(editor).getMessage());
      assertEquals("nothing defines movje; expected a name with a meaning", refusal(editor));
    }
  }
}
