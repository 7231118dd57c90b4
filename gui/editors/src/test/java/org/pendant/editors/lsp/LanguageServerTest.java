package org.pendant.editors.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DiagnosticCapabilities;
import org.eclipse.lsp4j.DocumentDiagnosticParams;
import org.eclipse.lsp4j.GeneralClientCapabilities;
import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializeResult;
import org.eclipse.lsp4j.InlayHintParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.MonikerParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentClientCapabilities;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextDocumentPositionParams;
import org.eclipse.lsp4j.WorkspaceDiagnosticParams;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.WorkspaceSymbolParams;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.editors.wire.ProtocolLog;

/** The server over its streams, as an editor talks to it. */
final class LanguageServerTest {
  private static final String URI = "file:///programs/cell.script";

  @TempDir Path folder;

  private static InitializeParams pulling() {
    TextDocumentClientCapabilities text = new TextDocumentClientCapabilities();
    text.setDiagnostic(new DiagnosticCapabilities());
    ClientCapabilities capabilities = new ClientCapabilities();
    capabilities.setTextDocument(text);
    InitializeParams asked = new InitializeParams();
    asked.setCapabilities(capabilities);
    return asked;
  }

  @Test
  void mistakesAreSentWhenATextIsOpenedAndChanged() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      editor.open(URI, "movje(1)");
      PublishDiagnosticsParams first = editor.nextDiagnostics();
      assertEquals(1, first.getDiagnostics().size());
      editor.replace(URI, 2, "sleep(1)");
      PublishDiagnosticsParams second = editor.nextDiagnostics();
      assertEquals(2, second.getVersion());
      assertEquals(List.of(), second.getDiagnostics());
    }
  }

  @Test
  void clientsThatAskForMistakesAreSentNothingAndTheSameTextIsNotToldTwice() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      InitializeResult result = editor.initialize(pulling());
      assertTrue(result.getCapabilities().getDiagnosticProvider().isWorkspaceDiagnostics());
      editor.open(URI, "movje(1)");
      DocumentDiagnosticParams ask = new DocumentDiagnosticParams(new TextDocumentIdentifier(URI));
      var report = editor.server().getTextDocumentService().diagnostic(ask).get().getLeft();
      assertEquals(1, report.getItems().size());
      ask.setPreviousResultId(report.getResultId());
      assertTrue(editor.server().getTextDocumentService().diagnostic(ask).get().isRight());
      assertFalse(editor.hasDiagnostics());
    }
  }

  @Test
  void aTextThatIsNotOpenIsRefused() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      ExecutionException refused =
          assertThrows(
              ExecutionException.class,
              () ->
                  editor
                      .server()
                      .getTextDocumentService()
                      .hover(
                          new HoverParams(
                              new TextDocumentIdentifier("file:///no.script"), new Position(0, 0)))
                      .get());
      assertEquals(
          "file:///no.script is not open",
          assertInstanceOf(ResponseErrorException.class, refused.getCause()).getMessage());
    }
  }

  @Test
  void nothingIsWrongInATextThatWasClosedMeanwhile() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      assertEquals(
          List.of(),
          editor
              .server()
              .getTextDocumentService()
              .diagnostic(
                  new DocumentDiagnosticParams(new TextDocumentIdentifier("file:///no.script")))
              .get()
              .getRelatedFullDocumentDiagnosticReport()
              .getItems());
    }
  }

  @Test
  void scriptsOfTheFoldersAreKnownWithoutBeingOpen() throws Exception {
    Files.writeString(folder.resolve("feeder.script"), "def feed_part():\n  slep(1)\nend\n");
    Files.createDirectories(folder.resolve("node_modules"));
    Files.writeString(folder.resolve("node_modules/x.script"), "def feed_other():\nend\n");
    InitializeParams asked = pulling();
    asked.setWorkspaceFolders(List.of(new WorkspaceFolder(folder.toUri().toString(), "cell")));
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(asked);
      var symbols =
          editor
              .server()
              .getWorkspaceService()
              .symbol(new WorkspaceSymbolParams("fp"))
              .get()
              .getRight();
      assertEquals(1, symbols.size());
      assertEquals("feed_part", symbols.getFirst().getName());
      var report =
          editor
              .server()
              .getWorkspaceService()
              .diagnostic(new WorkspaceDiagnosticParams(List.of()))
              .get();
      assertEquals(1, report.getItems().size());
      var file = report.getItems().getFirst().getWorkspaceFullDocumentDiagnosticReport();
      assertEquals(1, file.getItems().size());
    }
  }

  @Test
  void aFileOfTestsKnowsTheScriptsThatItImports() throws Exception {
    Path program = folder.resolve("cell.script");
    Files.writeString(program, "SIZE = 3\n# Picks one.\ndef pick(height):\nend\n");
    String uri = folder.resolve("cell_test.script").toUri().toString();
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      editor.open(
          uri,
          """
          import_script("cell.script")
          def test_pick():
            pick(SIZE)
            put(OTHER)
          end
          """);
      assertEquals(
          List.of("function put is not defined", "variable OTHER is never assigned"),
          editor.nextDiagnostics().getDiagnostics().stream()
              .map(each -> each.getMessage())
              .toList());
      Position pick = new Position(2, 3);
      Location definition =
          editor
              .server()
              .getTextDocumentService()
              .definition(new DefinitionParams(new TextDocumentIdentifier(uri), pick))
              .get()
              .getLeft()
              .getFirst();
      assertEquals(program.toUri().toString(), definition.getUri());
      assertEquals(2, definition.getRange().getStart().getLine());
      Hover hover =
          editor
              .server()
              .getTextDocumentService()
              .hover(new HoverParams(new TextDocumentIdentifier(uri), pick))
              .get();
      assertTrue(hover.getContents().getRight().getValue().contains("Picks one."));
    }
  }

  @Test
  void whatCannotBeReadIsPassedOver() throws Exception {
    List<String> log = new CopyOnWriteArrayList<>();
    try (ProtocolLog _ = new ProtocolLog(log::add);
        EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      editor.send("Content-Length: 3\r\n\r\n{x}");
      editor.send("Content-Length: zwei\r\n\r\n");
      editor.send("Content-Length: 2\r\n\r\n[]");
      editor.open(URI, "slep(1)");
      assertEquals(1, editor.nextDiagnostics().getDiagnostics().size());
      assertEquals(
          List.of("a message is left out, its head has no Content-Length"), editor.complaints());
      assertEquals(2, log.size(), log.toString());
    }
  }

  @Test
  void aDryRunTellsWhatStopsTheProgramAndHowLongItsLinesTake() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      editor.open(URI, "movej([0, -1.2, 0, -1.57, 0, 0])\nmovel(p[3, 0, 0.3, 0, 3.14, 0])\n");
      assertEquals(List.of(), editor.nextDiagnostics().getDiagnostics());
      var run = editor.nextDiagnostics().getDiagnostics().getFirst();
      assertEquals("pendant dry run", run.getSource());
      assertEquals(1, run.getRange().getStart().getLine());
      var hints =
          editor
              .server()
              .getTextDocumentService()
              .inlayHint(
                  new InlayHintParams(
                      new TextDocumentIdentifier(URI),
                      new Range(new Position(0, 0), new Position(0, 40))))
              .get();
      assertTrue(hints.getLast().getLabel().getLeft().matches("\\d\\.\\d\\d s"), hints.toString());
      var answer =
          editor
              .server()
              .dryRun(
                  new TextDocumentPositionParams(
                      new TextDocumentIdentifier(URI), new Position(0, 0)))
              .get();
      assertEquals("stopped", answer.get("outcome").getAsString());
      assertEquals(2, answer.get("line").getAsInt());
    }
  }

  @Test
  void thePoseUnderTheCaretIsAnswered() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      editor.open(URI, "x = p[0.1, -0.2, 0.3, 0, 3, 0]");
      var answer =
          editor
              .server()
              .pose(
                  new TextDocumentPositionParams(
                      new TextDocumentIdentifier(URI), new Position(0, 8)))
              .get();
      assertEquals("[0.1,-0.2,0.3,0.0,3.0,0.0]", answer.get("pose").toString());
    }
  }

  @Test
  void whatTheServerCannotDoIsRefusedInOneLine() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      ExecutionException refused =
          assertThrows(
              ExecutionException.class,
              () ->
                  editor
                      .server()
                      .getTextDocumentService()
                      .moniker(
                          new MonikerParams(new TextDocumentIdentifier(URI), new Position(0, 0)))
                      .get());
      assertEquals(
          "not supported",
          assertInstanceOf(ResponseErrorException.class, refused.getCause()).getMessage());
      assertEquals(List.of(), editor.faults());
    }
  }

  @Test
  void aClientThatShutsDownFirstLeavesInOrder() throws Exception {
    try (EditorClient editor = EditorClient.start()) {
      editor.initialize(new InitializeParams());
      editor.server().shutdown().get();
      editor.server().exit();
      assertTrue(editor.served());
    }
  }

  @Test
  void aStreamThatEndsEndsTheServer() throws IOException, InterruptedException {
    EditorClient editor = EditorClient.start();
    editor.close();
    assertFalse(editor.served());
  }

  @Test
  void placesAreCountedInBytesForClientsThatDo() throws Exception {
    InitializeParams asked = new InitializeParams();
    ClientCapabilities capabilities = new ClientCapabilities();
    capabilities.setGeneral(new GeneralClientCapabilities());
    capabilities.getGeneral().setPositionEncodings(List.of("utf-8", "utf-16"));
    asked.setCapabilities(capabilities);
    try (EditorClient editor = EditorClient.start()) {
      assertEquals("utf-8", editor.initialize(asked).getCapabilities().getPositionEncoding());
      String before = "x = \"ä\"  ";
      editor.open(URI, before + "movje(1)");
      assertEquals(
          before.getBytes(StandardCharsets.UTF_8).length,
          editor.nextDiagnostics().getDiagnostics().stream()
              .mapToInt(each -> each.getRange().getStart().getCharacter())
              .max()
              .orElseThrow());
    }
  }
}
