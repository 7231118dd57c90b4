/**
 * Editor text: what the script editor does with text, without a window. Open {@link
 * org.pendant.desktop.editor.text.AnalysedText} first.
 */
package org.pendant.desktop.editor.text;
