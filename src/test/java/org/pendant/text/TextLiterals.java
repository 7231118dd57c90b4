package org.pendant.text;

import com.sun.source.tree.AnnotationTree;
import com.sun.source.tree.CaseLabelTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionStatementTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.LambdaExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.StatementTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Literals in sources that read as something that is said to people. */
final class TextLiterals {
  /** Words beside one another, a capitalized word by itself, or a word before a colon. */
  private static final Pattern WORDS =
      Pattern.compile(
          "\\p{L}{2,}[\\p{L}'\u2019]*[,;:.)?!\"]* +[(\"]*\\p{L}+"
              + "|^\\P{L}*\\p{Lu}\\p{Ll}+[^\\p{L}\\d_.]*$|^\\p{Lu}\\p{Ll}+ "
              + "|^\\p{L}{3,}[,] *$|\\p{L}{3,}[:?!] *$|\\p{L}{3,} $"
              + "|^(, | )\\p{L}{3,}|^\\p{Lu}.*\\p{L}\\.$");

  /** Constraints of MigLayout. */
  private static final Pattern LAYOUT =
      Pattern.compile(
          "(\\P{Lu}*,"
              + " )?(grow[xy]?|fill|wrap|push[xy]?|span|hidemode|insets|gap|gap(top|left|right|bottom)|[wh](min|max)?|width|height|cell|top|center|right|split|sg|align[xy]?)("
              + " \\P{Lu}*|,\\P{Lu}*|$)|(\\[[^\\]\\p{Lu}]*\\][^\\[\\p{Lu}]*)+");

  private static final Pattern KEYS = Pattern.compile("((control|shift|alt|meta) )+\\S+");

  /** What is thrown when the program is wrong. */
  private static final Set<String> MISTAKES =
      Set.of(
          "IllegalArgumentException",
          "IllegalStateException",
          "AssertionError",
          "UnsupportedOperationException",
          "NoSuchElementException",
          "IndexOutOfBoundsException",
          "UncheckedIOException",
          "MigLayout");

  /** What is called with words that nobody reads, or that are the reference of functions. */
  private static final Set<String> CALLS =
      Set.of(
          "compile",
          "doc",
          "documented",
          "takes",
          "mayTake",
          "matches",
          "replaceAll",
          "replaceFirst",
          "split",
          "setName",
          "setRowConstraints",
          "setColumnConstraints",
          "getKeyStroke",
          "equals",
          "startsWith",
          "endsWith",
          "contains",
          "indexOf",
          "getProperty",
          "requireNonNull");

  private TextLiterals() {}

  /**
   * Those of sources.
   *
   * @return each as {@code Class: literal}, in the order of the sources
   */
  static List<String> of(List<Path> sources) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    List<String> found = new ArrayList<>();
    try (StandardJavaFileManager files =
        compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  new StringWriter(),
                  files,
                  null,
                  List.of("-proc:none"),
                  null,
                  files.getJavaFileObjectsFromPaths(sources));
      for (CompilationUnitTree unit : task.parse()) {
        String name = Path.of(unit.getSourceFile().toUri()).getFileName().toString();
        new Literals(unit.getPackageName() + "." + name.replace(".java", ""), found)
            .scan(unit, null);
      }
    }
    return found;
  }

  /** Whether a literal reads as a text. */
  static boolean isText(String literal) {
    return WORDS.matcher(literal).find()
        && !KEYS.matcher(literal).matches()
        && !LAYOUT.matcher(literal).matches();
  }

  private static final class Literals extends TreePathScanner<Void, Void> {
    private final String owner;
    private final List<String> found;

    Literals(String owner, List<String> found) {
      this.owner = owner;
      this.found = found;
    }

    @Override
    public Void visitAnnotation(AnnotationTree tree, Void unused) {
      return null;
    }

    @Override
    public Void visitLiteral(LiteralTree tree, Void unused) {
      if (tree.getValue() instanceof String text && isText(text) && !forPrograms()) {
        found.add(owner + ": " + text.replace("\r", "\\r").replace("\n", "\\n"));
      }
      return null;
    }

    /** Whether nobody reads what is at this place. */
    private boolean forPrograms() {
      Tree below = getCurrentPath().getLeaf();
      for (TreePath path = getCurrentPath().getParentPath();
          path != null;
          below = path.getLeaf(), path = path.getParentPath()) {
        Tree tree = path.getLeaf();
        if (tree instanceof CaseLabelTree || isMistake(tree) || isCall(tree, below)) {
          return true;
        }
        boolean expression =
            tree instanceof ExpressionTree || tree instanceof ExpressionStatementTree;
        if (tree instanceof LambdaExpressionTree
            || tree instanceof StatementTree && !expression
            || tree instanceof NewClassTree made && made.getClassBody() == below) {
          return false;
        }
      }
      return false;
    }

    private static boolean isMistake(Tree tree) {
      return tree instanceof NewClassTree made
          && MISTAKES.contains(made.getIdentifier().toString());
    }

    private static boolean isCall(Tree tree, Tree argument) {
      if (!(tree instanceof MethodInvocationTree call) || !call.getArguments().contains(argument)) {
        return false;
      }
      ExpressionTree method = call.getMethodSelect();
      String name =
          method instanceof MemberSelectTree select
              ? select.getIdentifier().toString()
              : method.toString();
      return CALLS.contains(name)
          || name.equals("putClientProperty")
              && !call.getArguments().getFirst().toString().contains("placeholder");
    }
  }
}
