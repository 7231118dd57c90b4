/** Texts that an editor has open, and places in them as the protocol counts. */
package org.pendant.editors.lsp.text;
