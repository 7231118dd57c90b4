/**
 * Script editor of the desktop, with its panels for outline, problems and search results. Open
 * {@link org.pendant.desktop.editor.ScriptEditor} first.
 */
package org.pendant.desktop.editor;
