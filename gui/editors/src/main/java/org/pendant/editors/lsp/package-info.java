/**
 * The language server: answers what an editor asks about URScript by the Language Server Protocol
 * 3.17, from the editor service of the language.
 */
package org.pendant.editors.lsp;
